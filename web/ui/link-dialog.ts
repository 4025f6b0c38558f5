/** The link to the current state, as a QR code for an audience. */
import { button, dialog } from './controls.ts';
import { h, setAttribute, setHidden, setText, svg } from './dom.ts';
import { QUIET, qrPath } from './qr.ts';

export interface LinkDialog {
  element: HTMLDialogElement;
  /** Opens the dialog; null: the open shape has no link. */
  open(link: string | null): Promise<void>;
}

const NO_LINK = 'Your own files stay on this machine. A link cannot contain them. To share a view, open a sample.';
const TOO_LONG = 'This link is too long for a QR code. Copy it instead.';

export function createLinkDialog(onCopy: () => void): LinkDialog {
  const path = svg('path', { fill: '#000' });
  const ground = svg('rect', { width: '100%', height: '100%', fill: '#fff' });
  const code = svg(
    'svg',
    { class: 'qr', role: 'img', 'aria-label': 'QR code of the link', 'data-testid': 'qr' },
    ground,
    path,
  );
  const text = h('p', { class: 'qr-link', 'data-testid': 'qr-link' });
  const copy = button({
    label: 'Copy the link',
    testId: 'qr-copy',
    icon: 'link',
    text: 'Copy the link',
    onClick: onCopy,
  });
  const element = dialog(
    { title: 'Open this view elsewhere', label: 'Link', testId: 'link-dialog', closeId: 'qr-close', kind: 'qr-dialog' },
    code,
    text,
    h('div', { class: 'button-row' }, copy),
  );

  const show = (words: string, d: string | null, size = 0): void => {
    setHidden(code, d === null);
    setAttribute(path, 'd', d);
    setAttribute(code, 'viewBox', `0 0 ${size} ${size}`);
    setText(text, words);
  };

  return {
    element,
    async open(link) {
      setHidden(copy, link === null);
      show(link ?? NO_LINK, null);
      if (!element.open) element.showModal();
      if (link === null) return;
      try {
        const { generate } = await import('lean-qr');
        const modules = generate(link);
        show(link, qrPath({ size: modules.size, get: (x, y) => modules.get(x, y) }), modules.size + 2 * QUIET);
      } catch {
        show(TOO_LONG, null);
      }
    },
  };
}
