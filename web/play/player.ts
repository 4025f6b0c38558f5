/** The demonstration with the button that starts and stops it. */
import { button } from '../ui/controls.ts';
import { h, setAttribute, setHidden, setText } from '../ui/dom.ts';
import { setIcon } from '../ui/icons.ts';
import { createDemonstration, SCENES } from './demonstration.ts';
import type { Demonstration } from './demonstration.ts';
import type { PlayState, LastAction } from './state.ts';

export interface Player extends Pick<Demonstration, 'start' | 'stop'> {
  button: HTMLButtonElement;
  /** Describes the current scene. */
  scene: HTMLElement;
}

export function createPlayer(show: (state: PlayState, lastAction: LastAction) => void): Player {
  const scene = h('span', { class: 'scene', 'data-testid': 'scene', hidden: true });
  const demonstration = createDemonstration((next, { lastAction }, index) => {
    show(next, lastAction);
    setText(scene, `${index + 1} of ${SCENES.length}`);
  });
  const toggle = button({
    label: 'Play the demonstration',
    testId: 'demonstration',
    icon: 'play',
    text: 'Watch',
    onClick: () => set(!demonstration.running),
  });
  const set = (on: boolean): void => {
    if (on === demonstration.running) return;
    if (on) demonstration.start();
    else demonstration.stop();
    setIcon(toggle, on ? 'pause' : 'play');
    setText(toggle.querySelector('span')!, on ? 'Stop' : 'Watch');
    setAttribute(toggle, 'aria-label', on ? 'Stop the demonstration' : 'Play the demonstration');
    setHidden(scene, !on);
  };
  return { button: toggle, scene, start: () => set(true), stop: () => set(false) };
}
