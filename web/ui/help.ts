/** Help: what the page does, its keys, and where the method comes from. */
import { button, checkbox } from './controls.ts';
import { h } from './dom.ts';

export interface ShortcutLine {
  keys: string;
  does: string;
}

export function createHelp(
  shortcuts: readonly ShortcutLine[],
  onShortcuts: (on: boolean) => void,
): {
  element: HTMLDialogElement;
  open(): void;
  update(singleKeys: boolean): void;
} {
  const switchOff = checkbox('Single-letter shortcuts', 'single-keys', onShortcuts);
  const element = h(
    'dialog',
    { class: 'dialog wide', 'data-testid': 'help-dialog', 'aria-label': 'Help' },
    h(
      'header',
      {},
      h('h2', {}, 'From poses to motion'),
      button({ label: 'Close', testId: 'help-close', icon: 'close', onClick: () => element.close() }),
    ),
    h(
      'p',
      {},
      'Open two or more poses of one mesh, with the same vertices and faces: several glTF, OBJ, PLY or OFF files, or one glTF with morph targets or an animation. It finds the smooth motion through them. Cubic splines run through rotations and stretches, not through positions, so that the shape bends and twists and hardly shrinks.',
    ),
    h(
      'p',
      {},
      'Drag the slider through the motion, and past both ends, where the motion is extrapolated. Drag the shape to turn it; the right button moves it, the wheel zooms. Your files stay on your machine.',
    ),
    h('h3', {}, 'Keyboard'),
    h(
      'dl',
      { class: 'shortcuts' },
      ...shortcuts.map(({ keys, does }) =>
        h('div', {}, h('dt', {}, ...keys.split('  ').map((key) => h('kbd', {}, key))), h('dd', {}, does)),
      ),
    ),
    switchOff.element,
    h('h3', {}, 'The method'),
    h(
      'p',
      {},
      'Cubic splines in linear rotation-invariant (LRI) shape space: Q. Xia, C. Chen, J. Liu, S. Li, A. Hao and H. Qin, “Efficient 4D shape completion from sparse samples via cubic spline fitting in linear rotation-invariant space”, Computers & Graphics, 2019.',
    ),
    h(
      'p',
      {},
      h('a', { href: './notices.txt', target: '_blank', rel: 'noopener', 'data-testid': 'notices' }, 'Licences'),
      ' of this page and of what it is made of.',
    ),
  );
  element.addEventListener('click', (event) => {
    if (event.target === element) element.close();
  });
  return { element, open: () => element.showModal(), update: (singleKeys) => switchOff.update(singleKeys) };
}
