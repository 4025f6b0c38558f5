/** Shows how to embed the open motion: a zip with everything needed, and lines to copy into a page. */
import { button, dialog } from './controls.ts';
import { h, setText } from './dom.ts';

export interface EmbedDialog {
  element: HTMLDialogElement;
  open(snippet: string): void;
}

export interface EmbedDialogEvents {
  /** Saves the zip. */
  onSave(): void;
  onError(error: unknown): void;
}

const EXAMPLES = './embed/examples/index.html';

export function createEmbedDialog({ onSave, onError }: EmbedDialogEvents): EmbedDialog {
  const code = h('code', {});
  const snippet = h(
    'pre',
    { class: 'snippet', dir: 'ltr', tabindex: 0, 'aria-label': 'Lines for your page', 'data-testid': 'embed-snippet' },
    code,
  );
  const said = h('p', { class: 'hint', role: 'status', 'data-testid': 'embed-said' });
  const copy = button({
    label: 'Copy the lines',
    testId: 'embed-copy',
    icon: 'link',
    text: 'Copy the lines',
    onClick: () => void navigator.clipboard.writeText(code.textContent).then(() => setText(said, 'Copied.'), onError),
  });
  const save = button({
    label: 'Download a zip with the page, the GLB and the package',
    testId: 'embed-save',
    icon: 'download',
    text: 'Download the zip',
    kind: 'primary',
    onClick: () => {
      element.close();
      onSave();
    },
  });
  const examples = h('a', { href: EXAMPLES, target: '_blank', rel: 'noopener' }, 'Examples and all attributes');
  const element = dialog(
    {
      title: 'Embed this on your page',
      label: 'Embed this',
      testId: 'embed-dialog',
      closeId: 'embed-close',
      kind: 'wide',
    },
    h(
      'p',
      {},
      'The zip contains a page, this motion as a GLB, and the package that shows it. Unpack it on any web server. ' +
        'To open the motion here again, drop the zip.',
    ),
    h('div', { class: 'button-row' }, save),
    h(
      'p',
      {},
      'For your own page, put the GLB and the folder ',
      h('code', {}, 'shapespline'),
      ' next to the page, and copy these lines into the page:',
    ),
    snippet,
    h('div', { class: 'button-row' }, copy),
    said,
    h('footer', {}, examples),
  );
  return {
    element,
    open(text) {
      setText(code, text);
      setText(said, '');
      if (!element.open) element.showModal();
    },
  };
}
