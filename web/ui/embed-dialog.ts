/** What is open, on somebody's own page: the lines to copy there, and the file to put beside them. */
import { button, dialog } from './controls.ts';
import { h, setText } from './dom.ts';

export interface EmbedDialog {
  element: HTMLDialogElement;
  open(snippet: string): void;
}

export interface EmbedDialogEvents {
  /** The project's GLB is wanted. */
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
    text: 'Copy',
    kind: 'primary',
    onClick: () => void navigator.clipboard.writeText(code.textContent).then(() => setText(said, 'Copied.'), onError),
  });
  const save = button({
    label: 'Download the project',
    testId: 'embed-save',
    icon: 'download',
    text: 'Download the GLB',
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
      'Put the GLB beside your page, and the npm package beside both as the folder ',
      h('code', {}, 'shapespline'),
      '. The GLB holds keys, times and options; these lines show it:',
    ),
    snippet,
    h('div', { class: 'button-row' }, copy, save),
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
