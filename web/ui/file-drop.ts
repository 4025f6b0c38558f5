/** Files from a drop anywhere on the page or from the system's picker, folders included, in natural order of name. */
import { h } from './dom.ts';
import { icon } from './icons.ts';

export interface PickedFile {
  /** Path relative to what was dropped. */
  name: string;
  file: File;
}

export const ACCEPTED = '.glb,.gltf,.bin,.obj,.ply,.off,.png,.jpg,.jpeg,.webp,model/gltf-binary,model/gltf+json';

const naturally = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

export function inNaturalOrder<T extends { name: string }>(files: readonly T[]): T[] {
  return [...files].sort((a, b) => naturally.compare(a.name, b.name));
}

/** Covers the page while files are dragged over it. */
export function createDropZone(onFiles: (files: PickedFile[]) => void): { element: HTMLElement } {
  const element = h('div', { class: 'drop-zone', 'data-testid': 'drop-zone', hidden: true },
    h('div', {}, icon('open'), h('p', {}, 'Drop the poses of one mesh: several files, or one with morph targets or an animation')));
  let depth = 0;
  const holdsFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  const leave = (): void => { depth = 0; element.hidden = true; };

  window.addEventListener('dragenter', (event) => {
    if (!holdsFiles(event)) return;
    depth += 1;
    element.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    if (!holdsFiles(event)) return;
    depth -= 1;
    if (depth <= 0) leave();
  });
  window.addEventListener('dragover', (event) => { if (holdsFiles(event)) event.preventDefault(); });
  window.addEventListener('drop', (event) => {
    if (!holdsFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    leave();
    void collect(event.dataTransfer).then((files) => { if (files.length > 0) onFiles(inNaturalOrder(files)); });
  });
  return { element };
}

/** Opens the system's picker. */
export function createPicker(testId: string, onFiles: (files: PickedFile[]) => void): { element: HTMLInputElement; open(): void } {
  const element = h('input', {
    type: 'file', multiple: true, accept: ACCEPTED, hidden: true, 'data-testid': testId, 'aria-label': 'Files', tabindex: -1,
    onchange: () => {
      const files = [...(element.files ?? [])].map((file) => ({ name: file.name, file }));
      element.value = '';
      if (files.length > 0) onFiles(inNaturalOrder(files));
    },
  });
  return { element, open: () => element.click() };
}

async function collect(transfer: DataTransfer): Promise<PickedFile[]> {
  // Entries are only valid during the event, so all are taken before the first await.
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...transfer.files];
  if (entries.every((entry) => entry === null || entry.isFile)) return plain.map((file) => ({ name: file.name, file }));
  const nested = await Promise.all(entries.map((entry) => (entry ? walk(entry, '') : [])));
  return nested.flat();
}

async function walk(entry: FileSystemEntry, path: string): Promise<PickedFile[]> {
  const name = path + entry.name;
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ name, file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const files: PickedFile[] = [];
  // A reader hands out a hundred entries at most each time.
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (batch.length === 0) return files;
    for (const child of batch) files.push(...await walk(child, `${name}/`));
  }
}
