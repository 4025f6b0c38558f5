/** The bar below the shape: standard views, up axis, and display options. */
import type { View } from '../model/state.ts';
import { button } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden } from './dom.ts';
import { createDisplayOptions } from './display-options.ts';
import type { DisplayOptionsEvents } from './display-options.ts';
import { rovingTabindex } from './roving-tabindex.ts';
import { popover } from './popover.ts';

export interface ViewBarProps {
  view: View;
  /** The up axis of files that do not specify it. */
  up: 'y' | 'z' | null;
  disabled: boolean;
}

export interface ViewBarEvents extends DisplayOptionsEvents {
  onUp(up: 'y' | 'z'): void;
}

/** `views`: buttons of the standard views. */
export function createViewBar(
  views: readonly HTMLElement[],
  events: ViewBarEvents,
): Component<ViewBarProps> & { toggleLook(): void } {
  const onPresent = (): void => {
    toggleLook();
    events.onPresent();
  };
  const displayOptions = createDisplayOptions({ ...events, onPresent });
  const toggle = button({
    label: 'Display',
    testId: 'look-toggle',
    icon: 'eye',
    text: 'Display',
    shortcut: 'V',
    onClick: () => toggleLook(),
  });
  let shownUp: ViewBarProps['up'] = null;
  const stand = button({
    label: 'Switch the up axis: these files do not specify one',
    testId: 'stand-up',
    text: 'Stand up',
    onClick: () => events.onUp(shownUp === 'z' ? 'y' : 'z'),
  });
  stand.classList.add('stand-up');
  const bar = h('div', { class: 'view-buttons', role: 'toolbar', 'aria-label': 'View' }, ...views, stand, toggle);
  rovingTabindex(bar);
  const element = h('div', { class: 'view-bar' }, displayOptions.element, bar);
  const toggleLook = popover(element, toggle, displayOptions.element);
  const draw = memo(({ view, up, disabled }: ViewBarProps) => {
    shownUp = up;
    setHidden(stand, up === null);
    setAttribute(stand, 'aria-pressed', String(up === 'z'));
    displayOptions.update(view);
    for (const control of bar.querySelectorAll('button')) control.disabled = disabled;
  });
  return { element, toggleLook, update: draw };
}
