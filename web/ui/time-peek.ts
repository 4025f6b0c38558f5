/** A small picture of the moment under the mouse, over the timeline. Not for touch, and never while something drags. */
import type { Pace } from '../model/pace.ts';
import { paceAt } from '../model/pace.ts';
import type { Range } from '../model/time-scale.ts';
import { momentWords } from '../model/frames.ts';
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle, setText } from './dom.ts';

export interface TimePeekProps {
  pace: Pace | null;
  range: Range;
  fps: number | null;
  /** The last picture that was made, as an address; null: none of what is open now. */
  picture: string | null;
}

export interface TimePeekParts {
  /** Over which the mouse moves. */
  over: HTMLElement;
  /** Within which the picture stays, and from whose left end places are counted. */
  frame: HTMLElement;
  /** The moment at a place on the page; null where there is none to look at. */
  timeAt(event: PointerEvent): number | null;
  /** A picture of this moment is wanted; null: none any more. */
  onPeek(t: number | null): void;
}

export type TimePeek = Component<TimePeekProps>;

export function createTimePeek({ over, frame, timeAt, onPeek }: TimePeekParts): TimePeek {
  let props: TimePeekProps | null = null;
  let moment: number | null = null;
  const image = h('img', { alt: '', draggable: 'false', hidden: true });
  const time = h('strong', {});
  const words = h('span', {});
  const element = h(
    'div',
    { class: 'time-peek card', 'aria-hidden': 'true', 'data-testid': 'time-peek', hidden: true },
    image,
    time,
    words,
  );

  const draw = (): void => {
    if (!props || moment === null) return;
    const { pace, range, fps, picture } = props;
    setHidden(image, picture === null);
    if (picture !== null) setAttribute(image, 'src', picture);
    setText(time, momentWords(moment, range, fps));
    const now = pace && paceAt(pace, moment);
    setText(words, !now ? '' : now.past ? 'swings past a key' : `${now.speed.toFixed(1)} × mean speed`);
  };

  const show = (t: number | null, x = 0): void => {
    if (t === moment && t === null) return;
    moment = t;
    setHidden(element, t === null);
    onPeek(t);
    if (t === null) return;
    draw();
    const half = element.offsetWidth / 2;
    const box = frame.getBoundingClientRect();
    const [least, most] = [half + EDGE_PX - box.left, innerWidth - half - EDGE_PX - box.left];
    setStyle(element, 'left', `${Math.min(Math.max(x - box.left, least), most).toFixed(1)}px`);
  };

  over.addEventListener('pointermove', (event) => {
    const looks = event.pointerType === 'mouse' && event.buttons === 0;
    show(looks ? timeAt(event) : null, event.clientX);
  });
  for (const name of ['pointerleave', 'pointerdown', 'pointercancel'] as const)
    over.addEventListener(name, () => show(null));

  return {
    element,
    update(next) {
      props = next;
      draw();
    },
  };
}

/** Of the page, that the picture keeps away from. */
const EDGE_PX = 8;
