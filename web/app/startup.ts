/** The start of a visit: its content, the work that starts after the first frame is drawn, and the hook for tests. */
import { clampTime } from '../model/time-scale.ts';
import type { Context } from './actions/context.ts';
import { showMotion } from './follow-state.ts';
import { openInitial } from './sources/open-initial.ts';
import { guideLink } from './sources/page-link.ts';
import { createTestHook, installTestHook } from './test-hook.ts';
import type { TestHook } from './test-hook.ts';
import type { Offers } from './view/offers.ts';

export interface StartupParts {
  context: Context;
  offers: Offers;
  onGuide(fragment: string): Promise<boolean>;
}

export interface Startup {
  /** Opens the URL's content; resolves when it is completely shown. */
  begin(): Promise<void>;
  /** Opens the content of the URL before the guide. */
  openBegun(): Promise<void>;
}

export function createStartup({ context, offers, onGuide }: StartupParts): Startup {
  const { session, display, viewState, feedback, files, remembered, link } = context;
  const { frameLoop } = display.playback;
  const onSamples: Parameters<typeof openInitial>[0]['onSamples'] = (samples) => {
    viewState.change({ samples, offline: !navigator.onLine });
    link.listen();
  };
  const open = (named: () => string): Promise<void> =>
    openInitial(
      { files, remembered, onSamples, say: feedback.say, onGuide, onStopped: offers.notReopened.offer },
      named,
    );
  let begun = '';
  const address = (): string => {
    if (!guideLink(location.hash)) begun = location.hash;
    return location.hash;
  };
  return {
    begin() {
      const ready = open(address).then(() => frameLoop.idle());
      const resetTo = async (fragment: string): Promise<void> => {
        const { reset } = await import('./reset.ts');
        return reset({ context, offers, visit: (to) => open(() => to) }, fragment);
      };
      installTestHook(testHookOf(context, ready, resetTo));
      const shown = ready
        .then(() => (session.workspace.info ? display.scene.viewer.firstSeen : undefined))
        .then(() => session.workspace.idle())
        .then(() => frameLoop.idle())
        .then(() => display.scene.viewer.drawn());
      void shown.then(() => listenToPlayground(context)).catch(feedback.onError);
      return shown;
    },
    openBegun: () => open(() => begun),
  };
}

async function listenToPlayground({ session, feedback, titleOf }: Context): Promise<void> {
  const { store, workspace, sequence } = session;
  const playground = await import('./sources/playground.ts');
  const title = (): string => titleOf(store.get().source);
  playground.listenToPlayground({ store, workspace, sequence, title, onError: feedback.onError });
}

function testHookOf(context: Context, ready: Promise<void>, reset: (fragment: string) => Promise<void>): TestHook {
  const { session, display, files } = context;
  const { store, workspace, sequence, range } = session;
  const { scene, playback } = display;
  const { frameLoop } = playback;
  return createTestHook({
    ready,
    sequence,
    viewer: scene.viewer,
    state: () => store.get(),
    shown: () => frameLoop.shown,
    difference: () => scene.difference?.percent ?? null,
    async seekExactly(t) {
      const time = clampTime(t, range());
      showMotion(context);
      store.set({ time, play: { ...store.get().play, playing: false } });
      await frameLoop.request(time);
    },
    async idle() {
      await files.idle();
      if (workspace.info) await scene.viewer.firstSeen;
      await workspace.idle();
      await frameLoop.idle();
    },
    reset,
    busy: () => files.busy || (frameLoop.busy && !store.get().play.playing),
  });
}
