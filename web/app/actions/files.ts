/** Commands that open files or compare with an animation. */
import { originalOf } from '../drawing/original.ts';
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
  /** `place`: the files were dropped before this key; null: not among the keys. */
  take: { run: ({ takeFiles }, picked: Picked, place?: number | null) => takeFiles.take(picked, place) },
  sample: { run: ({ files }, id: string) => files.sample(id) },
  own: { run: ({ openOwn }, project: string) => openOwn(project) },
  /** Closes the sheet that asks which keys to take of an animation. */
  asked: { run: asked },
  /** Takes the keys again, at these seconds of the animation. */
  takeKeys: {
    run: (context, animation: number, times: number[]) =>
      besideOriginal(context, () => context.files.resample(animation, times)),
  },
  /** Takes the fewest keys that stay within an error in percent of the diagonal. */
  takeFewest: {
    run: (context, animation: number, percent: number) =>
      besideOriginal(context, () => takeFewest(context, animation, percent)),
  },
  original: { run: showOriginal },
  pickTruth: { run: ({ overlays }) => overlays.pickTruth() },
  /** Compares with an animation of other files; null: with none. */
  compareWith: {
    async run(context, picked: Picked | null) {
      const { animation } = context;
      if (!picked) {
        animation.now?.dropTruth();
        return showOriginal(context, false);
      }
      if (await (await animation.get()).takeTruth(picked)) await showOriginal(context, true);
    },
  },
} satisfies Actions;

export function asked({ viewState, offerImport }: Context): void {
  viewState.change({ opening: false });
  offerImport(null);
}

async function takeFewest({ animation, viewState }: Context, of: number, percent: number): Promise<void> {
  viewState.change({ fewest: null });
  const fewest = await (await animation.get()).takeFewest(of, percent);
  if (fewest) viewState.change({ fewest });
}

/** Changes the keys and shows the animation again if it was shown. */
async function besideOriginal(context: Context, work: () => Promise<unknown>): Promise<void> {
  const { viewState } = context;
  const { original } = viewState.get();
  await work();
  if (original && !viewState.get().original) await showOriginal(context, true);
}

async function showOriginal(context: Context, shown: boolean): Promise<void> {
  const { session, display, viewState, analysis, animation } = context;
  viewState.change({ original: shown });
  const reference = shown ? await (await animation.get()).reference() : null;
  const { info } = session.workspace;
  display.scene.setOriginal(reference && info && originalOf(reference, info.faces));
  viewState.change({ original: reference !== null });
  analysis.invalidate();
  await display.playback.frameLoop.request(session.store.get().time);
}
