/** Showing the animation of the files beside the motion. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { OpenedState } from '../../web/app/view/view-state.ts';
import { createViewState } from '../../web/app/view/view-state.ts';
import { createIoControllers } from '../../web/app/io-controllers.ts';
import type { IoControllersParts } from '../../web/app/io-controllers.ts';
import { createStore } from '../../web/app/session/store.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import type { TimedShapes } from '../../web/study/reference-motion.ts';

const reads: ((reference: TimedShapes | null) => void)[] = [];
vi.mock('../../web/app/sources/animation.ts', () => ({
  Animation: class {
    reference = () => new Promise<TimedShapes | null>((resolve) => reads.push(resolve));
  },
}));
beforeEach(() => {
  vi.stubGlobal('BroadcastChannel', undefined);
  vi.stubGlobal('location', { hash: '' });
});
afterEach(() => void vi.unstubAllGlobals());

const ANIMATION: TimedShapes = { times: [0, 1], at: () => new Float32Array(9) };

async function page(animation = 0) {
  const viewState = createViewState(() => undefined);
  const shown = { original: null as object | null };
  const said: string[] = [];
  const { showOriginal } = createIoControllers({
    session: {
      store: createStore(EMPTY_STATE),
      workspace: { info: { animation, faces: Uint32Array.of(0, 1, 2) } },
      serve: () => undefined,
    },
    display: {
      scene: { setOriginal: (original: object | null) => Object.assign(shown, { original }) },
      playback: { frameLoop: { request: async () => undefined } },
    },
    analysis: { invalidate: () => undefined },
    feedback: { say: (text: string) => said.push(text) },
    viewState,
    onAnimation: () => undefined,
  } as unknown as IoControllersParts);
  /** Ticks or unticks the box. */
  const tick = async (to: boolean): Promise<void> => {
    void showOriginal(to);
    for (let turn = 0; turn < 5; turn += 1) await new Promise((resolve) => setTimeout(resolve, 0));
  };
  /** Ends the first reading. */
  const end = async (reference: TimedShapes | null = ANIMATION): Promise<void> => {
    reads.shift()!(reference);
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  const state = () => [viewState.opened.original, shown.original !== null];
  return { tick, end, state, said, change: (part: Partial<OpenedState>) => viewState.changeOpened(part) };
}

it('is not shown if the box is unticked while the animation is read', async () => {
  const { tick, end, state } = await page();
  await tick(true);
  await tick(false);
  await end();
  expect(state()).toEqual([false, false]);
  await tick(true);
  await tick(false);
  await tick(true);
  await end(null);
  expect(state()).toEqual([true, false]);
  await end();
  expect(state()).toEqual([true, true]);
});

it('is not shown for other files that were opened meanwhile', async () => {
  const { tick, end, state, change } = await page();
  await tick(true);
  change({ original: false });
  await end();
  expect(state()).toEqual([false, false]);
});

it('unticks with a sentence for keys that are not from it, and with none if the user cancels', async () => {
  const [others, own] = [await page(-1), await page()];
  await others.tick(true);
  await others.end(null);
  expect(others.state()).toEqual([false, false]);
  expect(others.said).toEqual([expect.stringContaining('The keys are not from this animation')]);
  await own.tick(true);
  await own.end(null);
  expect([own.state(), own.said]).toEqual([[false, false], []]);
});
