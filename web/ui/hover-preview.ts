/** A small image over the timeline: the shape at the time under the mouse. Not for touch, and never during a drag. */
import type { SpeedCurve } from '../model/speed-curve.ts';
import { speedAt } from '../model/speed-curve.ts';
import type { Range } from '../model/time-scale.ts';
import { momentWords } from '../model/frames.ts';
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle, setText } from './dom.ts';

export interface HoverPreviewProps {
  speedCurve: SpeedCurve | null;
  range: Range;
  fps: number | null;
  /** URL of the last image; null if there is none of the open shape. */
  picture: string | null;
}

export interface HoverPreviewParts {
  /** The element under the mouse. */
  over: HTMLElement;
  /** The image stays within this element. Positions are relative to its left edge. */
  frame: HTMLElement;
  /** The time at a position on the page; null if outside. */
  timeAt(event: PointerEvent): number | null;
  /** Requests an image at this time; null cancels it. */
  onPeek(t: number | null): void;
}

export type HoverPreview = Component<HoverPreviewProps>;

export function createHoverPreview({ over, frame, timeAt, onPeek }: HoverPreviewParts): HoverPreview {
  let props: HoverPreviewProps | null = null;
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
    const { speedCurve, range, fps, picture } = props;
    setHidden(image, picture === null);
    if (picture !== null) setAttribute(image, 'src', picture);
    setText(time, momentWords(moment, range, fps));
    const now = speedCurve && speedAt(speedCurve, moment);
    setText(words, !now ? '' : now.past ? 'overshoots a key' : `${now.speed.toFixed(1)} × mean speed`);
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

/** Distance from the edges of the page. */
const EDGE_PX = 8;
