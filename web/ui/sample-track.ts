/**
 * The timeline of an animation with a mark for each key. Drag marks or move them with arrow keys, click to add one,
 * press Delete to remove one.
 */
import { MAX_SAMPLED } from '../engine/api/option-table.ts';
import type { Span } from '../model/sample-times.ts';
import { shortTime } from '../model/sample-times.ts';
import { clamp } from '../model/time-scale.ts';
import { h, setAttribute, setStyle } from './dom.ts';
import { drag } from './pointer.ts';

/** onChange is called on every move, onTake with the final times. */
export function createSampleTrack(
  onChange: (times: number[]) => void,
  onTake: (times: number[]) => void,
): { element: HTMLElement; update(span: Span, times: readonly number[]): void } {
  let span: Span = { start: 0, end: 1 };
  let times: readonly number[] = [];
  const marks = h('div', { class: 'sample-marks' });
  const markAt = (event: Event): number => [...marks.children].indexOf(event.target as Element);
  const focus = (t: number): void => (marks.children[times.indexOf(t)] as HTMLElement | undefined)?.focus();
  const timeAt = (event: PointerEvent): number => {
    const { left, width } = marks.getBoundingClientRect();
    const share = clamp((event.clientX - left) / Math.max(width, 1), 0, 1);
    return share === 1 ? span.end : span.start + share * (span.end - span.start);
  };

  const pressed = (event: PointerEvent): void => {
    const known = markAt(event);
    if (known < 0 && times.length >= MAX_SAMPLED) return;
    event.preventDefault();
    const others = times.filter((_, i) => i !== known);
    let last = times[known] ?? timeAt(event);
    if (known < 0) onChange([...others, last]);
    drag(element, event, {
      onMove(moved) {
        const next = timeAt(moved);
        if (others.includes(next)) return; // two keys cannot share a time
        last = next;
        onChange([...others, last]);
      },
      onEnd() {
        onTake([...others, last]);
        focus(last);
      },
    });
  };
  const typed = (event: KeyboardEvent): void => {
    const index = markAt(event);
    if (index < 0) return;
    const step = ((span.end - span.start) / 100) * ({ ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0);
    const removes = (event.key === 'Delete' || event.key === 'Backspace') && times.length > 2;
    if (step === 0 && !removes) return;
    event.preventDefault();
    event.stopPropagation();
    const moved = clamp(times[index]! + step, span.start, span.end);
    const next = removes ? times.filter((_, i) => i !== index) : times.map((t, i) => (i === index ? moved : t));
    if (new Set(next).size < next.length) return;
    onTake(next);
    focus(removes ? next[Math.min(index, next.length - 1)]! : moved);
  };
  const element = h(
    'div',
    {
      class: 'sample-track',
      role: 'group',
      'data-testid': 'sample-track',
      'aria-label': 'Timeline of the animation',
      title: 'Click to add a key, drag to move it, Delete to remove it',
      onpointerdown: pressed,
      onkeydown: typed,
    },
    marks,
  );

  return {
    element,
    update(nextSpan, nextTimes) {
      [span, times] = [nextSpan, nextTimes];
      while (marks.children.length > times.length) marks.lastElementChild!.remove();
      while (marks.children.length < times.length)
        marks.append(h('button', { type: 'button', class: 'sample-mark', role: 'slider' }));
      times.forEach((t, index) => drawMark(marks.children[index] as HTMLElement, index, t, span));
    },
  };
}

function drawMark(mark: HTMLElement, index: number, t: number, { start, end }: Span): void {
  setStyle(mark, 'left', `${(100 * (t - start)) / Math.max(end - start, Number.MIN_VALUE)}%`);
  setAttribute(mark, 'aria-label', `Key ${index + 1}`);
  setAttribute(mark, 'aria-valuemin', start);
  setAttribute(mark, 'aria-valuemax', end);
  setAttribute(mark, 'aria-valuenow', t);
  setAttribute(mark, 'aria-valuetext', `${shortTime(t)} seconds`);
}
