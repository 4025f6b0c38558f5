/** Commands on importing and encoding the shape. */
import { setEncoding } from '../../model/edits.ts';
import type { Orientation } from '../../model/orientation.ts';
import { undoName } from '../../model/option-words.ts';
import { DEFAULT_ENCODING, GHOST_FACES } from '../../model/state.ts';
import type { Encoding } from '../../model/state.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';

export const SHAPE = {
  toggleGhost: {
    keys: ['n'],
    shown: 'N',
    does: 'Ghost mesh on or off',
    edits: true,
    run: ({ session: { store } }) =>
      store.edit('ghost mesh', (doc) =>
        setEncoding(doc, { ghostFaces: doc.encoding.ghostFaces > 0 ? 0 : GHOST_FACES }),
      ),
  },
  encoding: { run: changeEncoding },
  resetShape: {
    run: ({ session: { store }, viewState }) =>
      store.edit('shape defaults', (doc) => setEncoding(doc, viewState.opened.initial?.encoding ?? DEFAULT_ENCODING)),
  },
  orient: { run: ({ files }, orientation: Orientation) => files.reorient(orientation) },
  /** Sets the up axis, for file formats that do not specify it. */
  standUp: {
    run({ files, viewState }, up: 'y' | 'z') {
      const { orientation } = viewState.opened;
      return orientation && files.reorient({ ...orientation, up });
    },
  },
  objects: { run: ({ files }, names: string[]) => files.takeObjects(names) },
  component: { run: ({ display }, component: number | null) => display.marking.component(component) },
} satisfies Actions;

export function changeEncoding({ session: { store } }: Context, change: Partial<Encoding>): void {
  store.edit(undoName(change), (doc) => setEncoding(doc, change));
}
