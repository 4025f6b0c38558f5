/** The start of a visit: its content, the work that starts after the first frame is drawn, and the hook for tests. */
import { clampTime } from '../model/time-scale.ts';
import type { Context } from './actions/context.ts';
import { showMotion } from './follow-state.ts';
import { openInitial } from './sources/open-initial.ts';
import { guideLink } from './sources/page-link.ts';
import type { Sample } from './sources/samples.ts';
import { createTestHook, installTestHook } from './test-hook.ts';
import type { TestHook } from './test-hook.ts';
import type { Offers } from './view/offers.ts';

export interface StartupParts extends Pick<Context, 'viewState' | 'feedback' | 'files' | 'remembered' | 'link'> {
  offers: Offers;
}

export interface Startup {
  /** Opens what the URL names. */
  open(named: () => string, guide: GuideLinks): Promise<void>;
  /** Opens the content of the URL before the guide. */
  openBegun(): Promise<void>;
  /** The current URL's fragment. */
  address(): string;
}

/** Opens pages of the guide. */
export interface GuideLinks {
  open(fragment: string): Promise<boolean>;
  /** The URL names another page, or none (null). */
  follow(fragment: string | null): void;
}

export function createStartup({ offers, viewState, feedback, files, remembered, link }: StartupParts): Startup {
  const { say } = feedback;
  const onStopped = offers.notReopened.offer;
  let begun = '';
  const open = (named: () => string, onGuide: GuideLinks['open'], onListen: () => void): Promise<void> => {
    const onSamples = (samples: readonly Sample[]): void => {
      viewState.change({ samples, offline: !navigator.onLine });
      onListen();
    };
    return openInitial({ files, remembered, onSamples, say, onGuide, onStopped }, named);
  };
  return {
    open: (named, guide) => open(named, guide.open, () => link.listen(guide.follow)),
    openBegun: () =>
      open(
        () => begun,
        () => Promise.resolve(false),
        () => undefined,
      ),
    address() {
      if (!guideLink(location.hash)) begun = location.hash;
      return location.hash;
    },
  };
}

/** Opens the URL's content; resolves when it is completely shown. */
export function begin(context: Context, startup: Startup, offers: Offers, guide: GuideLinks): Promise<void> {
  const { session, display, feedback } = context;
  const { frameLoop } = display.playback;
  const ready = startup.open(startup.address, guide).then(() => frameLoop.idle());
  const resetTo = async (fragment: string): Promise<void> => {
    const { reset } = await import('./reset.ts');
    return reset({ context, offers, visit: (to) => startup.open(() => to, guide) }, fragment);
  };
  installTestHook(testHookOf(context, ready, resetTo));
  const shown = ready
    .then(() => (session.workspace.info ? display.scene.viewer.firstSeen : undefined))
    .then(() => session.workspace.idle())
    .then(() => frameLoop.idle())
    .then(() => display.scene.viewer.drawn());
  void shown.then(() => listenToPlayground(context)).catch(feedback.onError);
  return shown;
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
