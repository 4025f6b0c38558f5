/** The bar below the shape: standard views, up axis, and display options. */
import type { View } from '../model/state.ts';
import { button } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden } from './dom.ts';
import { createLook } from './look.ts';
import type { LookEvents } from './look.ts';
import { oneStop } from './one-stop.ts';
import { popover } from './popover.ts';

export interface ViewBarProps {
  view: View;
  /** The up axis of files that do not specify it. */
  up: 'y' | 'z' | null;
  disabled: boolean;
}

export interface ViewBarEvents extends LookEvents {
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
  const look = createLook({ ...events, onPresent });
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
  const bar = h('div', { class: 'view-buttons', role: 'toolbar', 'aria-label': 'View' }, ...views, stand, toggle);
  oneStop(bar);
  const element = h('div', { class: 'view-bar' }, look.element, bar);
  const toggleLook = popover(element, toggle, look.element);
  const draw = memo(({ view, up, disabled }: ViewBarProps) => {
    shownUp = up;
    setHidden(stand, up === null);
    setAttribute(stand, 'aria-pressed', String(up === 'z'));
    look.update(view);
    for (const control of bar.querySelectorAll('button')) control.disabled = disabled;
  });
  return { element, toggleLook, update: draw };
}
