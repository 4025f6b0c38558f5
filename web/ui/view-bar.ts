/** What lies on the viewport: standard views, the look of the shape, the phase in words, and the names of the views. */
import type { ViewName } from '../model/camera.ts';
import type { View } from '../model/state.ts';
import type { Phase } from '../model/time-scale.ts';
import { button } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import type { LookEvents } from './look.ts';
import { createLook } from './look.ts';
import { popover } from './popover.ts';

export interface ViewBarProps {
  view: View;
  /** Which axis is up where the files do not say it themselves. */
  up: 'y' | 'z' | null;
  disabled: boolean;
}

export interface ViewBarEvents extends LookEvents {
  onFit(view: ViewName | null): void;
  onUp(up: 'y' | 'z'): void;
}

export function createViewBar(events: ViewBarEvents): Component<ViewBarProps> & { toggleLook(): void } {
  const look = createLook({
    ...events,
    onPresent() {
      toggleLook();
      events.onPresent();
    },
  });
  const toggle = button({
    label: 'Display',
    testId: 'look-toggle',
    icon: 'eye',
    text: 'Display',
    shortcut: 'V',
    onClick: () => toggleLook(),
  });
  const view = (name: ViewName, label: string, key: string): HTMLButtonElement =>
    button({
      label: `${label} view`,
      testId: `view-${name}`,
      text: label,
      shortcut: key,
      onClick: () => events.onFit(name),
    });
  const fit = button({
    label: 'Fit the shape into view',
    testId: 'fit',
    icon: 'fit',
    text: 'Fit',
    shortcut: 'F',
    onClick: () => events.onFit(null),
  });
  let up: ViewBarProps['up'] = null;
  const stand = button({
    label: 'Stand the shape up, or lay it down: these files do not say which axis is up',
    testId: 'stand-up',
    text: 'Stand up',
    onClick: () => events.onUp(up === 'z' ? 'y' : 'z'),
  });
  const bar = h(
    'div',
    { class: 'view-buttons', role: 'toolbar', 'aria-label': 'View' },
    fit,
    view('front', 'Front', '1'),
    view('top', 'Top', '7'),
    view('right', 'Right', '3'),
    stand,
    toggle,
  );
  const element = h('div', { class: 'view-bar' }, look.element, bar);
  const toggleLook = popover(element, toggle, look.element);

  const draw = memo(({ view: state, up: present, disabled }: ViewBarProps) => {
    up = present;
    setHidden(stand, up === null);
    setAttribute(stand, 'aria-pressed', String(up === 'z'));
    look.update(state);
    for (const control of bar.querySelectorAll('button')) control.disabled = disabled;
  });
  return { element, toggleLook, update: draw };
}

/** What of the shape has turned inside out. */
export interface LostFaces {
  /** Of all faces, in [0, 1]. */
  share: number;
  /** One of them is known and can be shown. */
  hasPlace: boolean;
}

/** Fewer than this share of the faces cannot be seen. */
const SEEN_SHARE = 0.001;

/**
 * Where the moment lies, large enough to read from afar; the colour's meaning in words; a way out where the shape
 * breaks.
 */
export function createPhaseLabel(onShowLost: () => void): {
  element: HTMLElement;
  update(phase: Phase | null, lost: LostFaces): void;
} {
  const text = h('span', { 'data-testid': 'phase' });
  const lostText = h('span', {});
  const show = button({ label: 'Show where', testId: 'lost-show', text: 'Show where', onClick: onShowLost });
  const hint = h('div', { class: 'lost', 'data-testid': 'lost', hidden: true }, lostText, show);
  const element = h(
    'div',
    { class: 'phase-corner', hidden: true },
    hint,
    h('div', { class: 'phase' }, h('span', { class: 'dot' }), text),
  );
  return {
    element,
    update(phase, lost) {
      setHidden(element, phase === null);
      if (!phase) return;
      setAttribute(element, 'data-phase', phase.kind);
      setText(text, phase.text);
      setHidden(hint, !(lost.share >= SEEN_SHARE));
      setText(lostText, lostWords(lost.share, phase));
      setHidden(show, !lost.hasPlace);
    },
  };
}

function lostWords(share: number, { kind }: Phase): string {
  const percent = `${Number((100 * share).toPrecision(share < 0.1 ? 1 : 2))}\u00a0% of the faces fold over here`;
  return kind === 'beyond' ? `${percent}, this far from the keys.` : `${percent}.`;
}

export interface TileLabel {
  title: string;
  /** Measures in percent of the first key's; empty = not known. */
  detail: string;
  /** The same of the volume alone, in whole percent. */
  volume: string;
  x: number;
  y: number;
  width: number;
}

/** Between a divider and an edge as near as this there is no room for words. */
const NARROW_PX = 120;

/** The method's name and its measures over each of several views; beside a divider, the volume in large figures. */
export function createTileLabels(): {
  element: HTMLElement;
  update(labels: readonly TileLabel[], split: boolean): void;
} {
  const element = h('div', { class: 'tile-labels' });
  return {
    element,
    update(labels, split) {
      setAttribute(element, 'data-split', split);
      while (element.children.length > labels.length) element.lastElementChild?.remove();
      labels.forEach((label, index) => {
        const tile = (element.children[index] ??
          element.appendChild(
            h(
              'div',
              { class: 'tile-label', 'data-testid': `tile-${index}` },
              h('strong', {}),
              h('span', { class: 'measures' }, h('span', {}), h('span', { class: 'of' }, ' of the first key')),
              h('span', { class: 'volume' }, h('b', {}), h('span', { class: 'whose' }, ' of its volume')),
            ),
          )) as HTMLElement;
        setStyle(tile, 'left', `${label.x}px`);
        setStyle(tile, 'top', `${label.y}px`);
        setStyle(tile, 'width', `${label.width}px`);
        setAttribute(tile, 'data-edge', label.x > 0);
        setAttribute(tile, 'data-below', label.y > 0);
        setText(tile.firstElementChild!, label.title);
        setAttribute(tile, 'data-narrow', label.width < NARROW_PX);
        const [, measures, volume] = tile.children as unknown as [Element, HTMLElement, HTMLElement];
        setHidden(measures, split || label.detail === '');
        setHidden(volume, !split || label.detail === '');
        setText(measures.firstElementChild!, label.detail);
        setText(volume.firstElementChild!, label.volume);
      });
    },
  };
}
