/** The element's content: viewport, poster, progress, message and controls, with their slots and parts. */
import { h, setAttribute, setHidden, setStyle } from '../ui/dom.ts';
import { icon, setIcon } from '../ui/icons.ts';
import { drag, leaveScrolling } from '../ui/pointer.ts';
import { clamp, formatTime, length, snap } from '../model/time-scale.ts';
import type { Range } from '../model/time-scale.ts';
import type { Rect } from '../viewer/types.ts';
import { styleSheet } from './styles.ts';

export interface FrameEvents {
  onToggle(): void;
  onSeek(t: number): void;
  onKey(event: KeyboardEvent): void;
}

/** Pixels within which the timeline snaps to a key. */
const SNAP = 6;

export class Frame {
  readonly viewport = h('div', { part: 'viewport' });
  readonly controls: HTMLElement;
  private readonly image = h('img', { alt: '' });
  private readonly poster = h('div', { class: 'poster' }, slot('poster', this.image));
  private readonly bar = h('div', { part: 'progress' });
  private readonly progress = h('div', {}, slot('progress', this.bar));
  private readonly message = h('p', { part: 'message', role: 'alert' });
  private readonly play: HTMLButtonElement;
  private readonly thumb = h('div', { part: 'thumb' });
  private readonly timeline = h('div', { part: 'timeline', role: 'slider', tabindex: 0, 'aria-label': 'Time' });
  private readonly names = h('div', { 'aria-hidden': 'true' });
  private range: Range = [0, 1];
  private keys: readonly number[] = [];

  constructor(
    private readonly root: ShadowRoot,
    events: FrameEvents,
  ) {
    this.restyle();
    this.play = h('button', { part: 'play', type: 'button', onclick: () => events.onToggle() }, icon('play'));
    this.controls = h('div', {}, slot('controls', h('div', { part: 'controls' }, this.play, this.timeline)));
    const caption = h('div', { class: 'caption' }, h('slot'));
    root.append(this.viewport, this.names, this.poster, caption, this.controls, this.progress, this.message);
    for (const part of [this.message, this.progress]) setHidden(part, true);
    for (const part of [this.viewport, this.controls]) leaveScrolling(part);
    root.addEventListener('keydown', (event) => events.onKey(event as KeyboardEvent));
    // Offsets are in the timeline's own pixels, also in a container that the page rotates or scales.
    const to = (at: MouseEvent): void => events.onSeek(this.timeAt(at.offsetX));
    this.timeline.addEventListener('pointerdown', (event) => {
      // A touch may become a scroll, so it counts only after a sideways move or on release.
      if (event.pointerType !== 'touch') to(event);
      drag(this.timeline, event, { onMove: to });
    });
    this.timeline.addEventListener('click', to);
  }

  /** Applies the style sheet; called again for another document. */
  restyle(): void {
    const sheet = styleSheet(this.root.ownerDocument);
    if (sheet) this.root.adoptedStyleSheets = [sheet];
  }

  setLabel(alt: string): void {
    setAttribute(this.viewport, 'aria-label', alt || 'A moving shape');
  }

  setPoster(address: string, shown: boolean): void {
    setHidden(this.image, address === '');
    if (address !== '') setAttribute(this.image, 'src', address);
    setHidden(this.poster, !shown);
  }

  get posterShown(): boolean {
    return !this.poster.hidden;
  }

  /** Without any keyboard control, the viewport has the role of an image. */
  setTurnable(turnable: boolean, playable: boolean): void {
    const { viewport } = this;
    setStyle(viewport, 'pointer-events', turnable ? '' : 'none');
    setAttribute(viewport, 'role', turnable || playable ? 'region' : 'img');
    setAttribute(viewport, 'tabindex', turnable || playable ? 0 : null);
  }

  /** Names of views side by side; empty for a single view. */
  setNames(names: readonly string[]): void {
    this.names.replaceChildren(...names.map((name) => h('div', { part: 'name' }, name)));
  }

  get named(): boolean {
    return this.names.childElementCount > 0;
  }

  /** Each name is below its view, above the covered area. */
  placeNames(rects: readonly Rect[], covered: number): void {
    [...(this.names.children as HTMLCollectionOf<HTMLElement>)].forEach((name, i) => {
      const { x, y, width, height } = rects[i] ?? { x: 0, y: 0, width: 0, height: 0 };
      setStyle(name, 'left', `${x}px`);
      setStyle(name, 'top', `${y + height - covered}px`);
      setStyle(name, 'width', `${width}px`);
    });
  }

  setProgress(fraction: number | null): void {
    setHidden(this.progress, fraction === null);
    setStyle(this.bar, 'scale', `${fraction ?? 0} 1`);
  }

  /** `onRetry`: offers a retry. */
  setMessage(text: string | null, onRetry?: () => void): void {
    setHidden(this.message, text === null);
    const retry = onRetry && h('button', { part: 'retry', type: 'button', onclick: onRetry }, 'Try again');
    this.message.replaceChildren(text ?? '', ...(retry ? [retry] : []));
  }

  setPlaying(playing: boolean): void {
    setIcon(this.play, playing ? 'pause' : 'play');
    setAttribute(this.play, 'aria-label', playing ? 'Pause' : 'Play');
  }

  setKeys(range: Range, keys: readonly number[]): void {
    this.range = range;
    this.keys = keys;
    const ticks = keys.map((time) => {
      const tick = h('div', { part: 'key' });
      setStyle(tick, 'left', this.place(time));
      return tick;
    });
    this.timeline.replaceChildren(...ticks, this.thumb);
    setAttribute(this.timeline, 'aria-valuemin', range[0]);
    setAttribute(this.timeline, 'aria-valuemax', range[1]);
  }

  setTime(t: number, words: string): void {
    setStyle(this.thumb, 'left', this.place(t));
    setAttribute(this.timeline, 'aria-valuenow', clamp(t, ...this.range));
    setAttribute(this.timeline, 'aria-valuetext', `${formatTime(t, this.range)} s, ${words}`);
  }

  private place(t: number): string {
    return `${(100 * clamp((t - this.range[0]) / (length(this.range) || 1), 0, 1)).toFixed(2)}%`;
  }

  private timeAt(x: number): number {
    const { clientWidth, currentCSSZoom = 1 } = this.timeline as HTMLElement & { currentCSSZoom?: number };
    const width = Math.max(clientWidth * currentCSSZoom, 1);
    const span = length(this.range);
    const t = this.range[0] + clamp(x / width, 0, 1) * span;
    return snap(t, this.keys, (SNAP / width) * span);
  }
}

function slot(name: string, usual: Node): HTMLSlotElement {
  return h('slot', { name }, usual);
}
