/**
 * Where a file holds animations: which one the keys are taken from, how many or how near to it, and at which times of
 * its own timeline. What is chosen is taken at once.
 */
import { MOST_SAMPLED, SAMPLED_KEYS } from '../engine/api/option-table.ts';
import type { AnimationInfo, KeysInfo } from '../engine/api/types.ts';
import { checkbox, numberField, select } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setField, setHidden, setStyle, setText, uniqueId } from './dom.ts';

/** Of the error that the fewest keys are found for, in percent of the diagonal. */
const TOLERANCE = { least: 0.1, most: 20, default: 2 };
/** A mark that is moved by an arrow key is moved again soon. */
const TAKE_DELAY_MS = 300;

const NO_ANIMATION: AnimationInfo = { name: '', start: 0, end: 1, keys: 0, moves: false };

export interface SamplingProps {
  /** null: no animation. */
  info: KeysInfo | null;
  /** What was found for this error. */
  fewest: { keys: number; percent: number } | null;
  /** The animation is shown beside the motion. */
  original: boolean;
}

export interface SamplingEvents {
  onTake(animation: number, times: number[]): void;
  /** As few keys as keep the error below so many percent of the diagonal; resolves when they are taken or not. */
  onFewest(animation: number, percent: number): Promise<void>;
  onOriginal(shown: boolean): void;
}

export type Sampling = Component<SamplingProps>;

export function createSampling({ onTake, onFewest, onOriginal }: SamplingEvents): Sampling {
  let animations: readonly AnimationInfo[] = [];
  let chosen = 0;
  let times: number[] = [];
  /** The keys are of the animation, not beside it. */
  let taken = false;
  let timer = 0;
  /** The fewest keys are being looked for. */
  let searching = 0;
  let fewestFound = false;

  const span = (): AnimationInfo => animations[chosen] ?? NO_ANIMATION;
  const choose = (next: number[]): void => {
    times = [...new Set(next)].sort((a, b) => a - b);
    draw();
  };
  const takeSoon = (next: number[]): void => {
    taken = true;
    fewestFound = false;
    choose(next);
    window.clearTimeout(timer);
    timer = window.setTimeout(() => {
      timer = 0;
      onTake(chosen, times);
    }, TAKE_DELAY_MS);
  };

  const animation = select<string>('Animation', 'animation', [], (value) => {
    chosen = Number(value);
    takeSoon(evenly(span(), times.length));
  });
  const track = createTrack(choose, takeSoon);
  const list = h('input', {
    type: 'text',
    'data-testid': 'sample-times',
    'aria-label': 'Times of the keys in seconds',
    title: 'Times of the keys in seconds',
    spellcheck: false,
    autocomplete: 'off',
  });
  const reason = h('p', { class: 'reason', 'data-testid': 'sample-reason', hidden: true });
  list.addEventListener('change', () => {
    const read = readTimes(list.value, span());
    if (typeof read === 'string') complain(read);
    else takeSoon(read);
  });
  list.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') list.blur();
  });
  const count = numberField({
    label: 'Number of keys; another one spaces them evenly',
    testId: 'sample-count',
    min: 2,
    step: 1,
    onInput(value) {
      takeSoon(evenly(span(), Math.min(Math.round(value), MOST_SAMPLED)));
      setText(most, value > MOST_SAMPLED ? `An animation gives at most ${MOST_SAMPLED} keys.` : '');
      setHidden(most, value <= MOST_SAMPLED);
    },
  });
  const most = h('p', { class: 'reason', role: 'status', 'data-testid': 'sample-most', hidden: true });
  const search = async (): Promise<void> => {
    window.clearTimeout(timer);
    timer = 0;
    searching += 1;
    drawWay();
    await onFewest(chosen, tolerance.valueAsNumber || TOLERANCE.default);
    searching -= 1;
    drawWay();
  };
  const tolerance = numberField({
    label: 'Largest error in percent of the diagonal',
    testId: 'sample-tolerance',
    min: TOLERANCE.least,
    max: TOLERANCE.most,
    onInput(value) {
      setField(tolerance, String(value));
      void search();
    },
  });
  tolerance.value = tolerance.defaultValue = String(TOLERANCE.default);
  const name = uniqueId('sample-way');
  const way = (testId: string, hint: string, text: string, onChange: () => void): [HTMLInputElement, HTMLElement] => {
    const input = h('input', { type: 'radio', name, 'data-testid': testId, onchange: onChange });
    return [input, h('label', { class: 'check label', title: hint }, input, h('span', {}, text))];
  };
  const [byCount, countLabel] = way('sample-number', 'Keys at even times', 'Number of keys', () =>
    takeSoon(evenly(span(), count.valueAsNumber || times.length)),
  );
  const [byError, errorLabel] = way(
    'sample-fewest',
    'As few keys as keep the motion this near to the animation',
    'Fewest within',
    () => void search(),
  );
  const found = h('p', { class: 'hint', role: 'status', 'data-testid': 'sample-found', hidden: true });
  const original = checkbox('Show the animation beside the motion', 'sample-original', onOriginal);
  const title = h('strong', {}, '');
  const row = (...parts: HTMLElement[]): HTMLElement => h('div', { class: 'field row' }, ...parts);
  const element = h(
    'section',
    { class: 'group animation-source', hidden: true, 'data-testid': 'sampling', 'aria-label': 'Animation' },
    title,
    animation.element,
    row(countLabel, count),
    most,
    row(errorLabel, tolerance, h('span', { class: 'muted' }, '%')),
    found,
    original.element,
    h(
      'details',
      { class: 'details' },
      h('summary', { 'data-testid': 'sample-times-open' }, 'Times of the keys'),
      track.element,
      list,
      reason,
    ),
  );

  function complain(text: string): void {
    setText(reason, text);
    setHidden(reason, text === '');
  }

  function drawWay(): void {
    const fewest = searching > 0 || fewestFound;
    byError.checked = fewest;
    byCount.checked = !fewest && taken;
  }

  function draw(): void {
    complain('');
    drawWay();
    track.update(span(), times);
    setField(list, times.map(short).join(', '));
    const shown = taken ? String(times.length) : '';
    setField(count, shown);
    count.value = shown;
    count.placeholder = String(times.length);
  }

  const read = memo(({ info }: { info: KeysInfo | null }) => {
    animations = info?.animations ?? [];
    const firstMoving = animations.findIndex(({ moves }) => moves);
    setHidden(element, firstMoving < 0);
    // What was chosen meanwhile is taken next.
    if (!info || firstMoving < 0 || timer !== 0) return;
    chosen = info.animation < 0 ? firstMoving : info.animation;
    animation.update(String(chosen), animations.map(choiceOf));
    setText(
      title,
      animations.length > 1 ? `The files hold ${animations.length} animations` : 'The files hold an animation',
    );
    const before = taken;
    taken =
      info.animation >= 0 &&
      info.times.length <= MOST_SAMPLED &&
      info.times.every((t) => t >= span().start && t <= span().end);
    const next = taken ? info.times : evenly(span(), SAMPLED_KEYS);
    // What was taken is shown already, with what is to be said of the next choice.
    if (taken !== before || !sameTimes(next, times)) choose(next);
    else track.update(span(), times);
  });
  return {
    element,
    update(props) {
      read({ info: props.info });
      fewestFound = props.fewest !== null && timer === 0;
      drawWay();
      const says = props.fewest ? foundText(props.fewest) : coarseText(span(), taken ? times.length : Infinity);
      setHidden(found, says === '');
      setText(found, says);
      original.update(props.original);
    },
  };
}

/** One that is a single pose is listed, but no keys can be sampled from it. */
function choiceOf({ name, start, end, keys, moves }: AnimationInfo, index: number) {
  const count = keys === 1 ? '1 key' : `${keys.toLocaleString('en')} keys`;
  const what = moves ? `${(end - start).toFixed(2)} s, ${count}` : `one pose, ${count}`;
  return { value: String(index), label: `${name || `Animation ${index + 1}`}  (${what})`, disabled: !moves };
}

function sameTimes(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((t, index) => Math.abs(t - b[index]!) < 1e-6);
}

function foundText({ keys, percent }: { keys: number; percent: number }): string {
  return `${keys} keys: the motion is at most ${Number(percent.toPrecision(2))} % of the diagonal off.`;
}

/** Keys far apart are not the animation. */
function coarseText({ keys }: AnimationInfo, taken: number): string {
  return taken < keys ? `The animation itself has ${keys.toLocaleString('en')} keys.` : '';
}

function evenly({ start, end }: AnimationInfo, count: number): number[] {
  return Array.from({ length: count }, (_, i) => (i === count - 1 ? end : start + ((end - start) * i) / (count - 1)));
}

const short = (t: number): string => String(Number(t.toFixed(4)));

/** The times of a list, or what is wrong with it. */
function readTimes(text: string, { start, end }: AnimationInfo): number[] | string {
  const times = text
    .split(/[\s,;]+/)
    .filter((word) => word !== '')
    .map(Number);
  const unread = times.findIndex((t) => !Number.isFinite(t));
  if (unread >= 0) return `Time ${unread + 1} of the list is not a number. Separate the times by commas.`;
  const slack = 1e-4; // as they are shown
  const outside = times.find((t) => t < start - slack || t > end + slack);
  if (outside !== undefined)
    return `${short(outside)} s lies outside the animation, which runs from ${short(start)} to ${short(end)} s.`;
  if (new Set(times).size < 2) return 'Give at least two times.';
  if (times.length > MOST_SAMPLED) return `Give at most ${MOST_SAMPLED} times.`;
  return times.map((t) => Math.min(Math.max(t, start), end));
}

/** The animation's timeline: marks are dragged or moved by arrow keys, a click adds one, Delete removes it. */
function createTrack(
  onChange: (times: number[]) => void,
  onTake: (times: number[]) => void,
): {
  element: HTMLElement;
  update(span: AnimationInfo, times: number[]): void;
} {
  let span: AnimationInfo = NO_ANIMATION;
  let times: number[] = [];
  const marks = h('div', { class: 'sample-marks' });
  const element = h(
    'div',
    {
      class: 'sample-track',
      role: 'group',
      'data-testid': 'sample-track',
      'aria-label': 'Timeline of the animation',
      title: 'Click to add a key, drag to move it, Delete to remove it',
    },
    marks,
  );

  const timeAt = (event: PointerEvent): number => {
    const { left, width } = marks.getBoundingClientRect();
    const share = Math.min(Math.max((event.clientX - left) / Math.max(width, 1), 0), 1);
    return share === 1 ? span.end : span.start + share * (span.end - span.start);
  };
  const replaced = (index: number, t: number): number[] =>
    times.map((old, i) => (i === index ? Math.min(Math.max(t, span.start), span.end) : old));
  const focus = (t: number): void => (marks.children[times.indexOf(t)] as HTMLElement | undefined)?.focus();

  element.addEventListener('pointerdown', (event) => {
    const known = [...marks.children].indexOf(event.target as Element);
    const t = timeAt(event);
    if (known < 0 && times.length >= MOST_SAMPLED) return;
    event.preventDefault();
    const others = known < 0 ? times : times.filter((_, i) => i !== known);
    if (known < 0) onChange([...others, t]);
    element.setPointerCapture(event.pointerId);
    let last = known < 0 ? t : times[known]!;
    const move = (moved: PointerEvent): void => {
      const next = timeAt(moved);
      if (others.includes(next)) return; // two keys cannot share a time
      last = next;
      onChange([...others, last]);
    };
    const end = (): void => {
      element.removeEventListener('pointermove', move);
      onTake([...others, last]);
      focus(last);
    };
    element.addEventListener('pointermove', move);
    element.addEventListener('pointerup', end, { once: true });
    element.addEventListener('pointercancel', end, { once: true });
  });

  element.addEventListener('keydown', (event) => {
    const index = [...marks.children].indexOf(event.target as Element);
    if (index < 0) return;
    const step = ((span.end - span.start) / 100) * ({ ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0);
    const removes = (event.key === 'Delete' || event.key === 'Backspace') && times.length > 2;
    if (step === 0 && !removes) return;
    event.preventDefault();
    event.stopPropagation();
    const next = removes ? times.filter((_, i) => i !== index) : replaced(index, times[index]! + step);
    if (new Set(next).size < next.length) return;
    const goal = removes ? next[Math.min(index, next.length - 1)]! : next[index]!;
    onTake(next);
    focus(goal);
  });

  return {
    element,
    update(nextSpan, nextTimes) {
      [span, times] = [nextSpan, nextTimes];
      while (marks.children.length > times.length) marks.lastElementChild!.remove();
      while (marks.children.length < times.length)
        marks.append(h('button', { type: 'button', class: 'sample-mark', role: 'slider' }));
      times.forEach((t, index) => {
        const mark = marks.children[index] as HTMLElement;
        setStyle(mark, 'left', `${(100 * (t - span.start)) / Math.max(span.end - span.start, Number.MIN_VALUE)}%`);
        setAttribute(mark, 'aria-label', `Key ${index + 1}`);
        setAttribute(mark, 'aria-valuemin', span.start);
        setAttribute(mark, 'aria-valuemax', span.end);
        setAttribute(mark, 'aria-valuenow', t);
        setAttribute(mark, 'aria-valuetext', `${short(t)} seconds`);
      });
    },
  };
}
