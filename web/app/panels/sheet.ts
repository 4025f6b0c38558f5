/** The sheet for choosing keys of an animation that was just opened. */
import { h } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { ImportSheet } from '../../ui/import-sheet.ts';
import type { Commands } from '../actions/table.ts';
import type { Connect } from './connect.ts';
import type { Side } from './side.ts';

export interface SheetParts {
  sampling: Side['sampling'];
  commands: Commands;
  connect: Connect;
  onError(error: unknown): void;
  over: HTMLElement[];
  next: HTMLElement;
}

export function createSheet({ sampling, commands, connect, onError, over, next }: SheetParts): HTMLElement {
  const element = h('section', {
    class: 'opening',
    'aria-label': 'The animation',
    'data-testid': 'opening',
    hidden: true,
  });
  const sheet = lazyComponent<boolean, ImportSheet>(
    async () => {
      const [{ createImportSheet }] = await Promise.all([import('../../ui/import-sheet.ts'), sampling.need()]);
      const { asked: onClose, stepBack: onEscape } = commands;
      return createImportSheet({ element, choices: sampling.element, over, next, onClose, onEscape });
    },
    onError,
    element,
  );
  return connect(sheet, ({ viewState: { opening } }) => {
    if (opening) void sheet.need();
    return opening;
  });
}
