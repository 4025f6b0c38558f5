/** Commands that open files or compare with an animation. */
import type { InsertPosition } from '../../model/edits.ts';
import { fitKey, withTimings } from '../../model/fitted-timing.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';

type Picked = PickedFile[] | Promise<PickedFile[]>;

export const FILES = {
  pickFiles: {
    keys: ['ctrl+o'],
    shown: 'Ctrl+O',
    does: 'Open files',
    button: { in: 'start', testId: 'open', label: 'Open files', icon: 'open', text: 'Open' },
    run: ({ overlays }) => overlays.pickFiles(),
  },
  /** `place`: drop position among the keys; null if the files were dropped elsewhere. */
  take: { run: ({ fileIntake }, picked: Picked, place?: InsertPosition | null) => fileIntake.take(picked, place) },
  sample: { run: ({ files }, id: string) => files.sample(id) },
  own: { run: ({ openOwn }, project: string) => openOwn(project) },
  /** Closes the dialog for choosing keys of an animation. */
  asked: { run: asked },
  /** Samples the keys again at these times of the animation, in seconds. */
  takeKeys: {
    run: ({ files }, animation: number, times: number[]) => files.resample(animation, times),
  },
  /** Takes the fewest keys that stay within an error in percent of the diagonal. */
  takeFewest: { run: takeFewest },
  /** Fits the timing to the animation from which the keys were taken. */
  fitTiming: { run: fitTiming },
  plainTiming: {
    run: ({ session: { store } }) =>
      store.edit('timing', (doc) => withTimings(doc, { earlier: [], swing: [], regions: [] })),
  },
  original: { run: ({ showOriginal }, shown: boolean) => showOriginal(shown) },
  pickReference: { run: ({ overlays }) => overlays.pickReference() },
  /** Compares with the animation of other files; null stops comparing. */
  compareWith: {
    async run({ animation, showOriginal }, picked: Picked | null) {
      if (!picked) {
        animation.now?.dropReference();
        return showOriginal(false);
      }
      if (await (await animation.get()).takeReference(picked)) await showOriginal(true);
    },
  },
} satisfies Actions;

export function asked({ viewState, offerImport }: Context): void {
  viewState.changeOpened({ opening: false });
  offerImport(null);
}

async function takeFewest({ animation, viewState }: Context, of: number, percent: number): Promise<void> {
  viewState.changeOpened({ fewest: null });
  const fewest = await (await animation.get()).takeFewest(of, percent);
  if (fewest) viewState.changeOpened({ fewest });
}

async function fitTiming({ animation, session: { store }, viewState }: Context, of: number): Promise<void> {
  const { doc } = store.get();
  const key = fitKey(doc);
  const fit = await (await animation.get()).fitTiming(of);
  // The user may have changed the keys or opened other files meanwhile.
  if (!fit || fitKey(store.get().doc) !== key) return;
  viewState.changeOpened({ timing: { key, unseen: fit.unseen } });
  store.edit('fitted timing', (now) => withTimings(now, fit.timings));
}
