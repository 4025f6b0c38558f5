/**
 * The user's own files with all that is done to them, kept in this browser between visits unless the user wants
 * otherwise. They never leave your computer.
 */
import type { InputFile } from '../../engine/api/types.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { LastState, notedState } from './last-state.ts';
import {
  forgetProject,
  keepProject,
  markOpening,
  newProjectId,
  readProject,
  readShelf,
  updateProject,
} from './project-shelf.ts';
import type { ProjectOnShelf, StoredProject } from './project-shelf.ts';
import { bytesOf, currentSnapshot } from './snapshot.ts';

export interface RememberedFilesParts {
  store: Store;
  workspace: Workspace;
  /** Whether what is open is kept for the next visit, and all that is kept, the last changed first. */
  onChange(remembered: boolean, shelf: readonly ProjectOnShelf[]): void;
  say(text: string): void;
  onError(error: unknown): void;
}

/** What this visit knows of a project on the shelf. */
interface Kept {
  version: number;
  /** How many that are not of the files. */
  poses: number;
  files: InputFile[];
  /** The state that is written, as text; null: none that is known. */
  state: string | null;
}

/** A page that is left while it opens files has not been ended by them. */
const LEFT = 'shapespline.left-while-opening';
/** The project that this tab had last: another tab may have written since. */
const OF_TAB = 'shapespline.project-of-tab';
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

const KEPT = 'These files are remembered on this computer for your next visit. They never leave your computer.';
const NO_ROOM =
  'This browser cannot store these files: it has no room for them, or this is a private window. Export a GLB to save the project.';
const NOT_WRITTEN =
  'The last change could not be stored: this browser has no room for it. The previous version is kept. Export a GLB to save the project.';

export class RememberedFiles {
  private readonly tabs =
    typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel('shapespline remembered files');
  private readonly kept = new Map<string, Kept>();
  /** Projects not to be written: forgotten, or without room. */
  private readonly dropped = new Set<string>();
  private readonly lastState = new LastState();
  private shelf: readonly ProjectOnShelf[] = [];
  /** What was said of it last. */
  private shown: { remembered: boolean; shelf: readonly ProjectOnShelf[] } | null = null;
  /** What was opened or written last: the next visit starts with it. */
  private newest: string | null = null;
  /** The project that is written when the time is up. */
  private waiting: string | null = null;
  private timer = 0;
  private saving: Promise<void> = Promise.resolve();
  /** The user knows that files are kept, or will. */
  private told = false;
  private telling = 0;

  constructor(private readonly parts: RememberedFilesParts) {
    this.tabs?.addEventListener('message', ({ data }: MessageEvent<{ forgotten?: unknown } | null>) => {
      if (typeof data?.forgotten !== 'string') return;
      if (this.own === data.forgotten && this.isKept) this.parts.say('Another tab has deleted the remembered files.');
      this.giveUp(data.forgotten);
    });
  }

  /** Remembers what is open, and what is opened from now on; or forgets it, and keeps nothing from now on. */
  async toggle(): Promise<void> {
    const id = this.own;
    if (id !== null) await (this.isKept ? this.forget(id) : this.remember(id));
  }

  /** The state has changed. */
  follow(): void {
    const id = this.own;
    this.tellChange();
    if (id !== this.waiting) this.stopWaiting();
    // A new pose does not wait: leaving would lose it.
    const atOnce = id !== null && this.isKept && this.kept.get(id)!.poses !== this.added;
    if (atOnce) this.stopWaiting();
    if (this.timer || id === null || this.dropped.has(id) || !this.isWanted) return;
    this.waiting = id;
    this.timer = window.setTimeout(() => this.keep(id), atOnce ? 0 : SAVE_DELAY_MS);
  }

  /** The page may be left: what waits to be written is noted where that takes no time, and then written. */
  flush(): void {
    const { waiting: id } = this;
    if (!this.timer || id === null) return;
    this.stopWaiting();
    const state = this.parts.store.get();
    const before = this.kept.get(id);
    if (before && state.project === id && before.poses === this.added)
      this.lastState.note({ id, version: before.version, poses: before.poses, state });
    this.keep(id);
  }

  /** The projects of earlier visits: first that of this tab, then the last changed. A failure stops nothing. */
  async recall(): Promise<readonly ProjectOnShelf[]> {
    const setAside = await within(RECALL_MS, this.readList()).catch(() => 0);
    if (setAside)
      this.parts.say('The files remembered by an earlier visit can no longer be read. They were set aside.');
    const [ofTab, left] = [readSetting(OF_TAB, 'tab'), readSetting(LEFT)];
    const [own, others] = [this.shelf.filter(({ id }) => id === ofTab), this.shelf.filter(({ id }) => id !== ofTab)];
    return [...own, ...others].map((project) => ({ ...project, opening: project.opening && left !== project.id }));
  }

  /**
   * Opens what is kept by `open`, which resolves to null where something else was asked for meanwhile. A failure leaves
   * a mark, and so does a visit that ends meanwhile: the next one does not open it unasked.
   */
  async reopen(id: string, open: (remembered: StoredProject) => Promise<boolean | null>): Promise<boolean> {
    const project = await readProject(id);
    if (!project) {
      this.giveUp(id);
      throw new Error('These files are no longer stored, or cannot be read. Open them again.');
    }
    const { remembered, version } = project;
    const leave = (): void => writeSetting(LEFT, id);
    writeSetting(LEFT, null);
    window.addEventListener('pagehide', leave);
    await markOpening(id, true).catch(() => undefined);
    this.dropped.delete(id);
    const { files, poses, state } = remembered;
    const kept = { version, poses: poses.length, files, state: null };
    this.kept.set(id, kept);
    this.told = true;
    const last = notedState(id, version, poses.length);
    const opened = await open({ ...remembered, state: { ...(last ?? state), project: id } });
    if (opened) {
      this.kept.set(id, { ...kept, state: last ? null : JSON.stringify(this.parts.store.get()) });
      this.setNewest(id);
    }
    if (opened !== false) await markOpening(id, false).catch(() => undefined);
    window.removeEventListener('pagehide', leave);
    this.tellChange();
    return opened === true;
  }

  /** Nothing was ever kept, in this visit or before. */
  async forgetAll(): Promise<void> {
    this.stopWaiting();
    window.clearTimeout(this.telling);
    await this.saving;
    await this.readList();
    for (const { id } of this.shelf) await forgetProject(id);
    this.kept.clear();
    this.dropped.clear();
    this.shelf = [];
    this.told = false;
    this.setNewest(null);
    this.lastState.forget();
    for (const key of [LEFT, UNWANTED]) writeSetting(key, null);
    this.tellChange();
  }

  /** Whether leaving the page now would lose the user's work. */
  get unsaved(): boolean {
    const { store, workspace } = this.parts;
    const { source, doc } = store.get();
    const { pool } = workspace;
    const edited = store.history().past.length > 0;
    if (source.kind === 'files') return this.isKept ? this.added > this.kept.get(this.own!)!.poses : edited;
    // A link holds all of a sample but the poses that were added.
    return pool !== null && doc.keys.some(({ pose }) => pose >= pool.imported);
  }

  private setNewest(id: string | null): void {
    this.newest = id;
    writeSetting(OF_TAB, id, 'tab');
  }

  private get own(): string | null {
    return this.parts.store.get().project;
  }

  private get isKept(): boolean {
    return this.kept.has(this.own ?? '');
  }

  private get isWanted(): boolean {
    if (this.isKept) return true;
    const snapshot = readSetting(UNWANTED) === null ? currentSnapshot(this.parts.store, this.parts.workspace) : null;
    return snapshot !== null && bytesOf(snapshot) <= UNASKED_BYTES;
  }

  /** How many poses there are that are not of the files. */
  private get added(): number {
    const { pool } = this.parts.workspace;
    return pool ? pool.count - pool.imported : 0;
  }

  private tellChange(): void {
    const { isKept: remembered, shelf } = this;
    if (this.shown?.remembered === remembered && this.shown.shelf === shelf) return;
    this.shown = { remembered, shelf };
    this.parts.onChange(remembered, shelf);
  }

  /** Resolves to how many projects did not read. */
  private async readList(): Promise<number> {
    const { projects, setAside } = await readShelf();
    this.shelf = projects;
    this.tellChange();
    return setAside;
  }

  private giveUp(id: string): void {
    this.kept.delete(id);
    this.dropped.add(id);
    this.shelf = this.shelf.filter((project) => project.id !== id);
    this.tellChange();
  }

  private async forget(id: string): Promise<void> {
    this.giveUp(id);
    writeSetting(UNWANTED, 'yes');
    this.lastState.forget();
    await this.saving;
    await forgetProject(id);
    this.tabs?.postMessage({ forgotten: id });
    this.parts.say('Forgotten. Files are no longer remembered.');
  }

  private async remember(id: string): Promise<void> {
    this.dropped.delete(id);
    writeSetting(UNWANTED, null);
    await this.writeInTurn(id);
    if (this.kept.has(id)) this.parts.say('Remembered on this computer: the next visit starts with these files.');
  }

  private keep(id: string): void {
    this.timer = 0;
    void this.writeInTurn(id).then(() => {
      if (this.told || !this.kept.has(id)) return;
      this.told = true;
      this.telling = window.setTimeout(() => this.parts.say(KEPT), TELL_DELAY_MS);
    });
  }

  private stopWaiting(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
  }

  /** One after the other, so no state overtakes a later one. */
  private writeInTurn(id: string): Promise<void> {
    this.saving = this.saving
      .then(() => this.write(id))
      .catch(() => {
        const lost = this.kept.has(id);
        this.dropped.add(id);
        this.kept.delete(id);
        this.tellChange();
        this.parts.onError(new Error(lost ? NOT_WRITTEN : NO_ROOM));
      });
    return this.saving;
  }

  private async write(id: string): Promise<void> {
    const snapshot = currentSnapshot(this.parts.store, this.parts.workspace);
    if (!snapshot || this.own !== id || this.dropped.has(id)) return;
    const { files, history: _, ...changing } = snapshot;
    const text = JSON.stringify(snapshot.state);
    const before = this.kept.get(id);
    const wrote = (version: number): void => {
      this.kept.set(id, { version, poses: snapshot.poses.length, files, state: text });
      this.setNewest(id);
    };
    if (before?.files !== files) {
      const version = await keepProject(id, { files, ...changing });
      if (this.dropped.has(id)) return forgetProject(id);
      wrote(version);
      await this.readList();
      return;
    }
    if (before.state === text && this.newest === id) return;
    const version = await updateProject(id, before.version, changing);
    if (version === null) return this.branch(id);
    wrote(version);
    this.lastState.written(id, text);
  }

  /** Under a name of its own where another tab has written since: both versions stay. */
  private async branch(id: string): Promise<void> {
    if (this.dropped.has(id)) return;
    this.kept.delete(id);
    const other = newProjectId();
    this.parts.store.set({ project: other });
    this.parts.say('Another tab also changed these files. Both versions were kept.');
    await this.write(other);
  }
}

function within<T>(ms: number, work: Promise<T>): Promise<T | null> {
  return Promise.race([work, new Promise<null>((resolve) => setTimeout(resolve, ms, null))]);
}
