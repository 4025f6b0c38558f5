/** The state in the page's URL: written while playback is stopped, read when the user changes it, copied on request. */
import type { Doc } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import { readPermalink, writePermalink } from './permalink.ts';
import type { Permalink } from './permalink.ts';

export interface PageLinkParts {
  store: Store;
  /** The initial document of the open files; links store differences from it. */
  initial(): Doc | null;
  say(text: string): void;
  /** The URL names another state. */
  onLink(link: Permalink): void;
}

export interface PageLink {
  /**
   * Opens later changes of the URL. The initial URL is read by the code that opens the page. `onGuide`: the URL names a
   * page of the guide; null: it no longer does.
   */
  listen(onGuide: (fragment: string | null) => void): void;
  /** The state has changed. Updates the URL once listening. */
  follow(): void;
  copy(): Promise<void>;
  /** Fixes a fragment in the URL, independent of the state; null releases it. */
  pin(fragment: string | null): void;
  /** Writes a fragment (with its `#`, or '') to the URL. */
  replace(fragment: string): void;
  /** The full URL; null for the user's own files or if nothing is open. */
  address(): string | null;
}

/** The guide page that a fragment names, or null. */
export function guideLink(fragment: string): string | null {
  return /^#?(tour=\d+|figure=\w+)$/.exec(fragment)?.[1] ?? null;
}

/** A fragment with an unknown name; null if it names nothing. */
export function unknownLinkMessage(fragment: string): string | null {
  if (fragment.replace(/^#/, '') === '') return null;
  return 'The link does not name a sample or tour page, so it was ignored.';
}

/**
 * Delay after the first change that is not in the URL; later changes do not extend it. It is shorter than the delay for
 * storing the user's files. A returning user therefore finds these files, not the earlier sample.
 */
const WRITE_DELAY_MS = 300;

export function createPageLink({ store, initial, say, onLink }: PageLinkParts): PageLink {
  let timer = 0;
  let pinned: string | null = null;
  let guided: ((fragment: string | null) => void) | null = null;
  /** The last fragment written or received. */
  let known = location.hash;

  const replace = (fragment: string): void => {
    history.replaceState(null, '', location.pathname + location.search + fragment);
    known = location.hash;
  };

  const stopWaiting = (): void => {
    window.clearTimeout(timer);
    timer = 0;
  };

  const text = (): string | null => {
    const doc = initial();
    return doc && writePermalink(store.get(), doc);
  };

  const address = (): string | null => {
    const link = pinned ?? text();
    return link && new URL(`#${link}`, location.href).href;
  };

  const onChange = ({ newURL }: HashChangeEvent): void => {
    stopWaiting(); // A pending write would store the old state while the new one is loading.
    // The URL may have been rewritten since; the event has the requested one.
    const { hash } = new URL(newURL);
    known = hash;
    const page = guideLink(hash);
    const link = readPermalink(hash);
    if (page) guided?.(page);
    else if (link) onLink(link);
    else if (pinned && hash === '') guided?.(null);
    else {
      const strange = unknownLinkMessage(hash);
      if (strange) say(strange);
    }
  };

  return {
    listen(onGuide) {
      guided = onGuide;
      window.addEventListener('hashchange', onChange);
      known = location.hash;
      if (initial()) this.follow();
    },
    follow() {
      if (!guided || timer) return;
      timer = window.setTimeout(() => {
        timer = 0;
        if (location.hash !== known) return; // its event will follow
        const link = pinned ?? text();
        replace(link ? `#${link}` : '');
      }, WRITE_DELAY_MS);
    },
    replace,
    address,
    async copy() {
      const url = address();
      if (!url) return;
      try {
        await navigator.clipboard.writeText(url);
        say('Link copied.');
      } catch {
        replace(new URL(url).hash);
        say('The link is in the address bar now.');
      }
    },
    pin(fragment) {
      pinned = fragment;
      this.follow();
    },
  };
}
