/** Help: an overview of the page, its gestures and keys, and a reference to the method. */
import { button, checkbox, dialog } from './controls.ts';
import { h, setText } from './dom.ts';

export interface ShortcutLine {
  keys: string;
  does: string;
}

const GESTURES: readonly ShortcutLine[] = [
  { keys: 'Drag the shape', does: 'Rotate the shape' },
  { keys: 'Right drag  two fingers', does: 'Move the shape' },
  { keys: 'Wheel  pinch', does: 'Zoom' },
  { keys: 'Drag the timeline', does: 'Change the time, even beyond the ends' },
  {
    keys: 'Point at the timeline',
    does: 'Preview the shape at that time. The curve shows the speed; yellow marks overshoot',
  },
  { keys: 'Wheel over the timeline', does: 'Zoom in time' },
  { keys: 'Drag a diamond', does: 'Change a key’s time' },
  { keys: 'Drag a card', does: 'Change the order of keys' },
];

const BIBTEX = `@article{xia2019shapecompletion,
  author  = {Xia, Qing and Chen, Chengju and Liu, Jiarui and Li, Shuai and Hao, Aimin and Qin, Hong},
  title   = {Efficient 4D shape completion from sparse samples via cubic spline fitting in linear rotation-invariant space},
  journal = {Computers \\& Graphics},
  year    = {2019}
}
`;

function lines(list: readonly ShortcutLine[], kind = ''): HTMLElement {
  return h(
    'dl',
    { class: `shortcuts ${kind}` },
    ...list.map(({ keys, does }) =>
      h('div', {}, h('dt', {}, ...keys.split('  ').map((key) => h('kbd', {}, key))), h('dd', {}, does)),
    ),
  );
}

export interface Help {
  element: HTMLDialogElement;
  open(): void;
  update(singleKeys: boolean): void;
}

export function createHelp(shortcuts: readonly ShortcutLine[], onShortcuts: (on: boolean) => void): Help {
  const cite = button({
    label: 'Copy the BibTeX entry of the paper',
    testId: 'copy-bibtex',
    icon: 'link',
    text: 'Copy BibTeX',
    onClick: () =>
      void navigator.clipboard
        .writeText(BIBTEX)
        .then(() => setText(cited, 'Copied.'))
        .catch(() => setText(cited, BIBTEX)),
  });
  // Shows the entry itself if the clipboard is not available.
  const cited = h('pre', { class: 'cited', role: 'status' });
  const switchOff = checkbox('Single-letter shortcuts', 'single-keys', onShortcuts);
  const element = dialog(
    { title: 'From poses to motion', label: 'Help', testId: 'help-dialog', closeId: 'help-close', kind: 'wide' },
    h(
      'p',
      {},
      'Open two or more poses of one mesh, with the same vertices and faces: several glTF, OBJ, PLY or OFF files, or one glTF with morph targets or an animation. shapespline finds a smooth motion through them. It interpolates rotations and stretches instead of positions, so the shape bends and twists with almost no loss of volume.',
    ),
    h('p', {}, 'Your files stay on your machine.'),
    h('p', {}, h('a', { href: './manual.html', target: '_blank', rel: 'noopener' }, 'Manual')),
    h(
      'p',
      {},
      h('a', { href: '#tour=1', 'data-testid': 'help-tour', onclick: () => element.close() }, 'Take the tour'),
      ': ten steps through the method, each a state of this page. Afterwards, your current shape is restored.',
    ),
    h('h3', {}, 'Mouse and touch'),
    lines(GESTURES, 'gestures'),
    h('h3', {}, 'Keyboard'),
    lines(shortcuts),
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
      h(
        'a',
        { href: '#figure=1', 'data-testid': 'help-figures', onclick: () => element.close() },
        'The paper’s figures',
      ),
      ', one by one, as states of this page.',
    ),
    h(
      'p',
      {},
      'Playground: ',
      h('a', { href: './play.html', target: '_blank', rel: 'noopener', 'data-testid': 'playground' }, 'The bent ruler'),
      ' explains cubic splines. It opens in a new tab and can use the coordinates of the open shape.',
    ),
    h('div', { class: 'button-row' }, cite),
    cited,
    h(
      'p',
      {},
      h('a', { href: './notices.txt', target: '_blank', rel: 'noopener', 'data-testid': 'notices' }, 'Licences'),
      ' of this page and its dependencies.',
    ),
  );
  return { element, open: () => element.showModal(), update: (singleKeys) => switchOff.update(singleKeys) };
}
