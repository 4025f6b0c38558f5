/** Commands that open something, and that compare with an animation. */
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
  /** `place`: before which key they were put down, or null where they were not put among the keys. */
  take: { run: ({ takeFiles }, picked: Picked, place?: number | null) => takeFiles.take(picked, place) },
  sample: { run: ({ files }, id: string) => files.sample(id) },
  own: { run: ({ openOwn }, project: string) => openOwn(project) },
  /** The sheet on opening an animation has been seen. */
  asked: { run: asked },
  /** Takes the keys anew, at these seconds of the animation. */
  takeKeys: {
    run: (context, animation: number, times: number[]) =>
      besideOriginal(context, () => context.files.resample(animation, times)),
  },
  /** Looks for the fewest keys of an animation, for an error in percent of the diagonal. */
  takeFewest: {
    run: (context, animation: number, percent: number) =>
      besideOriginal(context, () => takeFewest(context, animation, percent)),
  },
  original: { run: showOriginal },
  pickTruth: { run: ({ overlays }) => overlays.pickTruth() },
  /** An animation of other files, or again that of the keys. */
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

/** Other keys leave the animation where it is shown. */
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
