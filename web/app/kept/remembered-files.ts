/**
 * The user's own files with all that is done to them, kept in this browser between visits unless the user wants
 * otherwise. They are sent nowhere.
 */
import type { InputFile } from '../../engine/api/types.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { AppState } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import {
  forgetProject,
  keepProject,
  markOpening,
  newProjectId,
  readProject,
  readShelf,
  updateProject,
} from './project-shelf.ts';
import type { ProjectOnShelf, Remembered } from './project-shelf.ts';
import { bytesOf, currentWork } from './work.ts';

export interface RememberedFilesParts {
  store: Store;
  workspace: Workspace;
  /** Whether what is open is kept for the next visit, and all that is kept, the last changed first. */
  onChange(remembered: boolean, shelf: readonly ProjectOnShelf[]): void;
  say(text: string): void;
  onError(error: unknown): void;
}

export interface RememberedFiles {
  /** Remembers what is open, and what is opened from now on; or forgets it, and keeps nothing from now on. */
  toggle(): Promise<void>;
  /** The state has changed. */
  follow(): void;
  /** The page may be left: what waits to be written is noted where that takes no time, and then written. */
  flush(): void;
  /** What earlier visits left, the last changed first. Nothing that goes wrong here keeps the page from starting. */
  recall(): Promise<readonly ProjectOnShelf[]>;
  /**
   * Opens what is kept by `open`, which resolves to null where something else was asked for meanwhile. A failure leaves
   * a mark, and so does a visit that ends meanwhile: the next one does not open it unasked.
   */
  reopen(id: string, open: (remembered: Remembered) => Promise<boolean | null>): Promise<boolean>;
  /** Nothing was ever kept, in this visit or before. */
  forgetAll(): Promise<void>;
  /** Whether leaving the page now would lose the user's work. */
  readonly unsaved: boolean;
}

/** From one tab to the others of this page. */
interface News {
  forgotten: string;
}

/** The last state of a project, where the page was left before it was written to this version. */
interface Note {
  id: string;
  version: number;
  poses: number;
  state: AppState;
}

/** What this visit knows of a project on the shelf. */
interface Kept {
  version: number;
  /** How many that are not of the files. */
  poses: number;
  files: InputFile[];
  /** The state that is written, as text. */
  state: string;
}

/** A page that is left while it opens files has not been ended by them. */
const LEFT = 'shapespline.left-while-opening';
const NOTE = 'shapespline.last-state';
/** Kept where the user wants no files to be kept. */
const UNWANTED = 'shapespline.keep-no-files';
/** After the first change that is not kept: further ones do not put it off. */
const SAVE_DELAY_MS = 500;
/** Another tab can hold a browser's storage for any time: the page starts without it then. */
const RECALL_MS = 10_000;
/** More is kept only where the user asks for it: the page stands still while a copy is made. */
const UNASKED_BYTES = 128e6;

/** What was said of opening can be read first. */
const TELL_DELAY_MS = 4000;

const KEPT = 'These files are remembered on this computer for your next visit. They are sent nowhere.';
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
  const kept = new Map<string, Kept>();
  /** Projects that are not to be written any more: forgotten, or without room. */
  const dropped = new Set<string>();
  let shelf: readonly ProjectOnShelf[] = [];
  let timer = 0;
  let telling = 0;
  /** The project that is written when the time is up. */
  let waiting: string | null = null;
  let saving: Promise<void> = Promise.resolve();
  let told = false;
  /** What was opened or written last: the next visit starts with it. */
  let newest: string | null = null;

  const own = (): string | null => store.get().project;
  const isKept = (): boolean => kept.has(own() ?? '');
  /** The state that this visit has noted, until it is written. */
  let lastNoted: string | null = null;
  const wrote = (id: string, text: string): void => {
    if (lastNoted !== null && text !== lastNoted) return;
    lastNoted = null;
    if (readNote()?.id === id) writeSetting(NOTE, null);
  };
  const added = (): number => (workspace.pool ? workspace.pool.count - workspace.pool.imported : 0);
  let shown: { remembered: boolean; shelf: readonly ProjectOnShelf[] } | null = null;
  const changed = (): void => {
    const remembered = isKept();
    if (shown?.remembered === remembered && shown.shelf === shelf) return;
    shown = { remembered, shelf };
    onChange(remembered, shelf);
  };

  const readList = async (): Promise<number> => {
    const { projects, setAside } = await readShelf();
    shelf = projects;
    changed();
    return setAside;
  };

  const giveUp = (id: string): void => {
    kept.delete(id);
    dropped.add(id);
    shelf = shelf.filter((project) => project.id !== id);
    changed();
  };

  tabs?.addEventListener('message', ({ data }: MessageEvent<Partial<News> | null>) => {
    if (typeof data?.forgotten !== 'string') return;
    if (own() === data.forgotten && isKept()) say('Forgotten in another tab.');
    giveUp(data.forgotten);
  });

  /** Under a name of its own where another tab has written since: both versions stay. */
  const write = async (id: string): Promise<void> => {
    const work = currentWork(store, workspace);
    if (!work || own() !== id || dropped.has(id)) return;
    const { files, options, poses, offset, state } = work;
    const text = JSON.stringify(state);
    const before = kept.get(id);
    if (before?.files === files) {
      if (before.state === text && newest === id) return;
      const version = await updateProject(id, before.version, { options, poses, offset, state });
      if (version !== null) {
        kept.set(id, { version, poses: poses.length, files, state: text });
        newest = id;
        wrote(id, text);
      } else if (!dropped.has(id)) {
        kept.delete(id);
        const other = newProjectId();
        store.set({ project: other });
        say('Another tab has changed these files, too. Both versions are kept.');
        await write(other);
      }
      return;
    }
    const version = await keepProject(id, { files, options, poses, offset, state });
    if (dropped.has(id)) return forgetProject(id);
    kept.set(id, { version, poses: poses.length, files, state: text });
    newest = id;
    await readList();
  };

  /** One after the other, so that a later state is not overtaken. */
  const inTurn = (id: string, failure: string): Promise<void> => {
    saving = saving
      .then(() => write(id))
      .catch(() => {
        const lost = kept.has(id);
        dropped.add(id);
        kept.delete(id);
        changed();
        onError(new Error(lost ? failure : NO_ROOM));
      });
    return saving;
  };

  const wanted = (): boolean => {
    const work = readSetting(UNWANTED) === null && currentWork(store, workspace);
    return isKept() || (work !== false && work !== null && bytesOf(work) <= UNASKED_BYTES);
  };

  const forget = async (id: string): Promise<void> => {
    giveUp(id);
    writeSetting(UNWANTED, 'yes');
    writeSetting(NOTE, null);
    await saving;
    await forgetProject(id);
    tabs?.postMessage({ forgotten: id } satisfies News);
    say('Forgotten, and files are not remembered any more.');
  };

  const remember = async (id: string): Promise<void> => {
    dropped.delete(id);
    writeSetting(UNWANTED, null);
    await inTurn(id, NOT_WRITTEN);
    if (kept.has(id)) say('Remembered on this computer: the next visit starts with these files.');
  };

  const keep = (id: string): void => {
    timer = 0;
    void inTurn(id, NOT_WRITTEN).then(() => {
      if (told || !kept.has(id)) return;
      told = true;
      telling = window.setTimeout(say, TELL_DELAY_MS, KEPT);
    });
  };
  const stopWaiting = (): void => {
    window.clearTimeout(timer);
    timer = 0;
  };

  return {
    async toggle() {
      const id = own();
      if (id !== null) await (isKept() ? forget(id) : remember(id));
    },
    follow() {
      const id = own();
      changed();
      if (id !== waiting) stopWaiting();
      // A new pose does not wait: leaving would lose it.
      const atOnce = id !== null && isKept() && kept.get(id)!.poses !== added();
      if (atOnce) stopWaiting();
      if (timer || id === null || dropped.has(id) || !wanted()) return;
      waiting = id;
      timer = window.setTimeout(keep, atOnce ? 0 : SAVE_DELAY_MS, id);
    },
    flush() {
      if (!timer || waiting === null) return;
      stopWaiting();
      const state = store.get();
      const before = kept.get(waiting);
      if (before && state.project === waiting && before.poses === added()) {
        const { version, poses } = before;
        writeSetting(NOTE, JSON.stringify({ id: waiting, version, poses, state } satisfies Note));
        lastNoted = JSON.stringify(state);
      }
      keep(waiting);
    },
    async recall() {
      const setAside = await within(RECALL_MS, readList()).catch(() => 0);
      if (setAside) say('The files remembered by an earlier visit can no longer be read. They were set aside.');
      return shelf.map((project) => ({ ...project, opening: project.opening && readSetting(LEFT) !== project.id }));
    },
    async reopen(id, open) {
      const project = await readProject(id);
      if (!project) {
        giveUp(id);
        throw new Error('These files are no longer stored, or cannot be read. Open them again.');
      }
      const { remembered, version } = project;
      const leave = (): void => writeSetting(LEFT, id);
      writeSetting(LEFT, null);
      window.addEventListener('pagehide', leave);
      await markOpening(id, true).catch(() => undefined);
      dropped.delete(id);
      const { files } = remembered;
      const poses = remembered.poses.length;
      kept.set(id, { version, poses, files, state: '' });
      told = true;
      const last = noted(id, version, poses);
      const opened = await open({ ...remembered, state: { ...(last ?? remembered.state), project: id } });
      if (opened) {
        kept.set(id, { version, poses, files, state: last ? '' : JSON.stringify(store.get()) });
        newest = id;
      }
      if (opened !== false) await markOpening(id, false).catch(() => undefined);
      window.removeEventListener('pagehide', leave);
      changed();
      return opened === true;
    },
    async forgetAll() {
      stopWaiting();
      window.clearTimeout(telling);
      await saving;
      await readList();
      for (const { id } of shelf) await forgetProject(id);
      kept.clear();
      dropped.clear();
      shelf = [];
      told = false;
      newest = null;
      lastNoted = null;
      for (const key of [LEFT, NOTE, UNWANTED]) writeSetting(key, null);
      changed();
    },
    get unsaved() {
      const { source, doc } = store.get();
      const { pool } = workspace;
      const edited = store.history().past.length > 0;
      if (source.kind === 'files') return isKept() ? added() > kept.get(own()!)!.poses : edited;
      // A link holds all of a sample but the poses that were added.
      return pool !== null && doc.keys.some(({ pose }) => pose >= pool.imported);
    },
  };
}

function readNote(): Note | null {
  try {
    return JSON.parse(readSetting(NOTE) ?? 'null') as Note | null;
  } catch {
    return null;
  }
}

/** What the last visit noted of a project as it was left, unless it was written after all. */
function noted(id: string, version: number, poses: number): AppState | null {
  const note = readNote();
  if (note?.id !== id || note.poses !== poses) return null;
  // A write that was under way then may have ended since.
  return version === note.version || version === note.version + 1 ? note.state : null;
}

function within<T>(ms: number, work: Promise<T>): Promise<T | null> {
  return Promise.race([work, new Promise<null>((resolve) => setTimeout(resolve, ms, null))]);
}
