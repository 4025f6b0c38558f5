/** The state in the page's URL: written while nothing plays, read when the user changes it, copied on demand. */
import type { Doc } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import { readPermalink, writePermalink } from './permalink.ts';
import type { Permalink } from './permalink.ts';

export interface PageLinkParts {
  store: Store;
  /** The document that the open files started with: links are written against it. */
  initial(): Doc | null;
  say(text: string): void;
  /** The address names another state. */
  onLink(link: Permalink): void;
  /** The URL names a page of the guide; null: it no longer does. */
  onGuide(fragment: string | null): void;
}

export interface PageLink {
  /** From now on, changes of the URL are opened; the code that opens the page reads the initial one. */
  listen(): void;
  /** The state has changed: the address follows where it is listened to. */
  follow(): void;
  copy(): Promise<void>;
  /** Keeps a fragment in the address, whatever the state becomes; null: no longer. */
  pin(fragment: string | null): void;
  /** Writes a fragment (with its `#`, or '') into the address. */
  replace(fragment: string): void;
  /** The whole address; null where the user's own files are open, or nothing. */
  address(): string | null;
}

/** The page of the guide that a fragment names, or null. */
export function guideLink(fragment: string): string | null {
  return /^#?(tour=\d+|figure=\w+)$/.exec(fragment)?.[1] ?? null;
}

/** A fragment that names nothing that there is; null where it names nothing at all. */
export function strangeLink(fragment: string): string | null {
  if (fragment.replace(/^#/, '') === '') return null;
  return 'The link does not name a sample or tour page, so it was ignored.';
}

/**
 * Delay after the first change that is not in the URL; later changes do not extend it. Shorter than the delay of
 * storing the user's files, so a returning user finds these and not the sample before them.
 */
const WRITE_DELAY_MS = 300;

export function createPageLink({ store, initial, say, onLink, onGuide }: PageLinkParts): PageLink {
  let timer = 0;
  let pinned: string | null = null;
  let listening = false;
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
    stopWaiting(); // it would write what was, while the new one is on its way
    // What was written into the address since then is not what was asked for.
    const { hash } = new URL(newURL);
    known = hash;
    const page = guideLink(hash);
    const link = readPermalink(hash);
    if (page) onGuide(page);
    else if (link) onLink(link);
    else if (pinned && hash === '') onGuide(null);
    else {
      const strange = strangeLink(hash);
      if (strange) say(strange);
    }
  };

  return {
    listen() {
      window.addEventListener('hashchange', onChange);
      known = location.hash;
      listening = true;
      if (initial()) this.follow();
    },
    follow() {
      if (!listening || timer) return;
      timer = window.setTimeout(() => {
        timer = 0;
        if (location.hash !== known) return; // the user has gone elsewhere, and its event is still to come
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
