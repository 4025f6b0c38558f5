/** Files dropped anywhere on the page or chosen in the system's picker, including folders, in natural order of name. */
import { inNaturalOrder } from '../engine/api/numbered-names.ts';
import { ACCEPTED, droppedFiles } from './dropped-files.ts';
import type { PickedFile } from './dropped-files.ts';
import { unzipped } from './zipped-files.ts';
import { h, setAttribute, setText } from './dom.ts';
import { icon } from './icons.ts';

/** Drop position in pixels of the page. */
export interface DropPoint {
  x: number;
  y: number;
}

/**
 * Covers the page while files are dragged over it, except for elements with their own drop handling. `onOver` describes
 * such an element; null for the default. Searching folders takes time and may fail.
 */
export function createDropZone(
  onFiles: (files: Promise<PickedFile[]>, at: DropPoint) => void,
  onOver: (at: DropPoint | null) => string | null,
): {
  element: HTMLElement;
} {
  const here = h('p', { class: 'drop-here' });
  const element = h(
    'div',
    { class: 'drop-zone', 'data-testid': 'drop-zone', hidden: true },
    h(
      'div',
      {},
      icon('open'),
      h(
        'p',
        {},
        'Drop the poses of one mesh: several files or their folder, or one file with morph targets or an animation',
      ),
      h(
        'p',
        { class: 'drop-hint' },
        'A single pose of the open mesh becomes a key. Drop it on the row of keys to choose its place',
      ),
    ),
    here,
  );
  let depth = 0;
  const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  const leave = (): void => {
    depth = 0;
    element.hidden = true;
    onOver(null);
  };

  window.addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    depth += 1;
    element.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    if (!hasFiles(event)) return;
    depth -= 1;
    if (depth <= 0) leave();
  });
  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    const words = onOver({ x: event.clientX, y: event.clientY });
    setText(here, words ?? '');
    setAttribute(element, 'data-here', words !== null);
  });
  window.addEventListener('drop', (event) => {
    if (!hasFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    leave();
    onFiles(ordered(droppedFiles(event.dataTransfer)), { x: event.clientX, y: event.clientY });
  });
  return { element };
}

/** Sorts files in natural order of name and replaces each zip by its files. */
const ordered = async (picked: PickedFile[] | Promise<PickedFile[]>): Promise<PickedFile[]> =>
  inNaturalOrder(await unzipped(await picked));

/** Opens the system's file picker. */
export function createPicker(
  testId: string,
  onFiles: (files: Promise<PickedFile[]>) => void,
): { element: HTMLInputElement; open(): void } {
  const element = h('input', {
    type: 'file',
    multiple: true,
    accept: ACCEPTED,
    hidden: true,
    'data-testid': testId,
    'aria-label': 'Files',
    tabindex: -1,
    onchange: () => {
      const files = [...(element.files ?? [])].map((file) => ({ name: file.name, file }));
      element.value = '';
      if (files.length > 0) onFiles(ordered(files));
    },
  });
  return { element, open: () => element.click() };
}
