/** The user's own files, kept in this browser between visits where the user has asked for it. They are sent nowhere. */
import type { InputFile } from '../../engine/api/types.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import {
  forgetProject,
  keepProject,
  newProjectId,
  readProject,
  setProjectAside,
  updateProject,
} from './project-shelf.ts';
import type { Changing, KeptProject, Remembered } from './project-shelf.ts';

export interface RememberedFilesParts {
  store: Store;
  workspace: Workspace;
  /** Whether the files are kept for the next visit. */
  onChange(remembered: boolean): void;
  say(text: string): void;
  onError(error: unknown): void;
}

export interface RememberedFiles {
  /** Remembers what is open, or forgets it. */
  toggle(): Promise<void>;
  /** The state has changed. */
  follow(): void;
  /** What an earlier visit left, or null. Nothing that goes wrong here keeps the page from starting. */
  recall(): Promise<KeptProject | null>;
  /** Opens what was recalled by `open`; a visit that ends meanwhile leaves a sign of it. */
  reopen(kept: KeptProject, open: (remembered: Remembered) => Promise<boolean>): Promise<boolean>;
}

/** From one tab to the others of this page. */
interface News {
  /** The project that is kept now; null: it was forgotten. */
  kept: string | null;
  /** The project that was kept before. */
  before: string;
}

/** A page that is left while it opens files has not been ended by them. */
const LEFT = 'shapespline.left-while-opening';
const SAVE_DELAY_MS = 500;
/** Another tab can hold a browser's storage for any time: the page starts without it then. */
const RECALL_MS = 10_000;

const NO_ROOM =
  'This browser cannot store these files: it has no room for them, or this is a private window. Export a GLB to save the project.';
const NOT_WRITTEN =
  'The last change could not be stored: this browser has no room for it. The version before is kept. Export a GLB to save the project.';

export function createRememberedFiles({
  store,
  workspace,
  onChange,
  say,
  onError,
}: RememberedFilesParts): RememberedFiles {
  const tabs = typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel('shapespline remembered files');
  /** The project of this tab that is kept, and its files. */
  let own: { id: string; files: InputFile[] | null } | null = null;
  let timer = 0;
  let saving: Promise<void> = Promise.resolve();

  const change = (now: typeof own): void => {
    own = now;
    if (!now) window.clearTimeout(timer);
    onChange(now !== null);
  };

  const tell = (news: News): void => tabs?.postMessage(news);

  const lose = (why: string): void => {
    change(null);
    say(why);
  };

  tabs?.addEventListener('message', ({ data }: MessageEvent<News>) => {
    if (!own || data.kept === own.id) return;
    if (data.kept === null && data.before === own.id) lose('Forgotten in another tab.');
    else if (data.kept !== null) lose('Another tab has remembered its own files instead of these.');
  });

  const changing = (): Changing | null => {
    const { options, pool } = workspace;
    const state = store.get();
    if (!pool || state.source.kind !== 'files') return null;
    const poses = Array.from({ length: pool.count - pool.imported }, (_, index) => pool.imported + index).map(
      (pose) => ({ name: pool.keys.info.names[pose] ?? '', positions: pool.keys.positions(pose) }),
    );
    return { options, poses, state };
  };

  /** Files are written once, the rest with every change. */
  const save = async (): Promise<void> => {
    const part = changing();
    const { input } = workspace;
    if (!part || !own) return;
    const { id, files } = own;
    if (files === input) {
      if (!(await updateProject(id, part)) && own)
        lose('Another tab has changed the remembered files: these are no longer among them.');
      return;
    }
    const next = newProjectId();
    if (!(await keepProject(next, { files: input, ...part }, id))) {
      lose('Another tab has changed the remembered files: these are not among them.');
      return;
    }
    if (own) change({ id: next, files: input });
    tell({ kept: next, before: id });
  };

  /** One after the other, so that a later state is not overtaken. */
  const saveInTurn = (): Promise<void> => {
    saving = saving.then(save).catch(() => {
      change(null);
      onError(new Error(NOT_WRITTEN));
    });
    return saving;
  };

  const remember = async (): Promise<void> => {
    const part = changing();
    if (!part) return;
    const id = newProjectId();
    const { input } = workspace;
    try {
      await keepProject(id, { files: input, ...part }, null);
    } catch {
      onError(new Error(NO_ROOM));
      return;
    }
    change({ id, files: input });
    tell({ kept: id, before: '' });
    say('Remembered on this computer: the next visit starts with these files.');
  };

  const forget = async (id: string): Promise<void> => {
    change(null);
    await saving;
    await forgetProject(id);
    tell({ kept: null, before: id });
    say('Forgotten: the next visit starts with a sample.');
  };

  return {
    toggle: () => (own ? forget(own.id) : remember()),
    follow() {
      if (!own) return;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => void saveInTurn(), SAVE_DELAY_MS);
    },
    async recall() {
      try {
        const kept = await within(RECALL_MS, readProject());
        return kept && { ...kept, opening: kept.opening && readSetting(LEFT) !== kept.id };
      } catch {
        // A browser that keeps nothing has nothing to set aside.
        const aside = await within(
          RECALL_MS,
          setProjectAside().then(() => true),
        ).catch(() => false);
        if (aside) say('The files remembered by an earlier visit can no longer be read. They were set aside.');
        return null;
      }
    },
    async reopen({ id, remembered }, open) {
      const leave = (): void => writeSetting(LEFT, id);
      writeSetting(LEFT, null);
      window.addEventListener('pagehide', leave);
      await updateProject(id, { opening: true }).catch(() => undefined);
      const opened = await open(remembered);
      await updateProject(id, { opening: false }).catch(() => undefined);
      window.removeEventListener('pagehide', leave);
      // The files as the workspace holds them now are those that are kept.
      if (opened) change({ id, files: workspace.input });
      return opened;
    },
  };
}

function within<T>(ms: number, work: Promise<T>): Promise<T | null> {
  return Promise.race([work, new Promise<null>((resolve) => setTimeout(resolve, ms, null))]);
}
