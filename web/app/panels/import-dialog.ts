/** The dialog for choosing keys of an animation that was just opened. */
import { h } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { ImportDialog } from '../../ui/import-dialog.ts';
import type { Commands } from '../actions/table.ts';
import type { Connect } from './connect.ts';
import type { Sidebar } from './sidebar.ts';

export interface ImportDialogParts {
  sampling: Sidebar['sampling'];
  commands: Commands;
  connect: Connect;
  onError(error: unknown): void;
  over: HTMLElement[];
  next: HTMLElement;
}

export function connectImportDialog({
  sampling,
  commands,
  connect,
  onError,
  over,
  next,
}: ImportDialogParts): HTMLElement {
  const element = h('section', {
    class: 'opening',
    'aria-label': 'The animation',
    'data-testid': 'opening',
    hidden: true,
  });
  const dialog = lazyComponent<boolean, ImportDialog>(
    async () => {
      const [{ createImportDialog }] = await Promise.all([import('../../ui/import-dialog.ts'), sampling.need()]);
      const { asked: onClose, stepBack: onEscape } = commands;
      return createImportDialog({ element, choices: sampling.element, over, next, onClose, onEscape });
    },
    onError,
    element,
  );
  return connect(dialog, ({ opened: { opening } }) => {
    if (opening) void dialog.need();
    return opening;
  });
}
