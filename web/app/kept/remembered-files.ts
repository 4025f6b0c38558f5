/**
 * Stores the user's files and edits in this browser between visits, unless the user declines. They are never uploaded.
 */
import type { InputFile } from '../../engine/api/types.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { LastState, notedState } from './last-state.ts';
import * as browserShelf from './project-shelf.ts';
import type { ProjectOnShelf, StoredProject } from './project-shelf.ts';
import { bytesOf, currentSnapshot } from './snapshot.ts';

export interface RememberedFilesParts {
  store: Store;
  workspace: Workspace;
  /** Whether the open files are stored for the next visit, and all stored projects, the last changed first. */
  onChange(remembered: boolean, shelf: readonly ProjectOnShelf[]): void;
  say(text: string): void;
  onError(error: unknown): void;
  /** Where projects are stored: this browser, unless given. */
  storage?: ProjectStorage;
}

type ProjectStorage = Omit<typeof browserShelf, 'readRecord' | 'areFiles'>;

/** This visit's knowledge of a stored project. */
interface Kept {
  version: number;
  /** Number of poses that are not from the files. */
  poses: number;
  files: InputFile[];
  /** The stored state as text; null if unknown. */
  state: string | null;
}

/** Marks a page closed during opening, so opening is not blamed for its end. */
const LEFT = 'shapespline.left-while-opening';
/** The last project of this tab; another tab may have written since. */
const OF_TAB = 'shapespline.project-of-tab';
/** Storage key for the user's choice to store no files. */
const UNWANTED = 'shapespline.keep-no-files';
/** Delay after the first unsaved change; further changes do not extend it. */
const SAVE_DELAY_MS = 500;
/** Another tab can block the browser's storage indefinitely. After this time the page starts without it. */
const RECALL_MS = 10_000;
/** Larger files are stored only on request, because the page freezes while copying them. */
const UNASKED_BYTES = 128e6;

/** Delay of the notice about stored files, so the user can read the opening message first. */
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
  /** Projects that are not written: forgotten by the user, or without room. */
  private readonly dropped = new Set<string>();
  private readonly lastState = new LastState();
  private shelf: readonly ProjectOnShelf[] = [];
  /** The last reported state. */
  private shown: { remembered: boolean; shelf: readonly ProjectOnShelf[] } | null = null;
  /** The last project opened or written. The next visit opens it first. */
  private newest: string | null = null;
  /** The project to write when the delay ends. */
  private waiting: string | null = null;
  private timer = 0;
  private saving: Promise<void> = Promise.resolve();
  /** Number of writes that have not ended. */
  private writes = 0;
  /** The user has been informed that files are stored. */
  private told = false;
  private telling = 0;

  private readonly storage: ProjectStorage;

  constructor(private readonly parts: RememberedFilesParts) {
    this.storage = parts.storage ?? browserShelf;
    this.tabs?.addEventListener('message', ({ data }: MessageEvent<{ forgotten?: unknown } | null>) => {
      if (typeof data?.forgotten !== 'string') return;
      if (this.own === data.forgotten && this.isKept) this.parts.say('Another tab has deleted the remembered files.');
      this.giveUp(data.forgotten);
    });
  }

  /** Starts storing the open files and all later ones, or removes all files and stops storing. */
  async toggle(): Promise<void> {
    const id = this.own;
    if (id !== null) await (this.isKept ? this.forget(id) : this.remember(id));
  }

  /** Call when the state has changed. */
  follow(): void {
    const id = this.own;
    this.tellChange();
    if (id !== this.waiting) this.stopWaiting();
    // A new pose is written immediately, because leaving the page would lose it.
    const atOnce = id !== null && this.isKept && this.kept.get(id)!.poses !== this.added;
    if (atOnce) this.stopWaiting();
    if (this.timer || id === null || this.dropped.has(id) || !this.isWanted) return;
    this.waiting = id;
    this.timer = window.setTimeout(() => this.keep(id), atOnce ? 0 : SAVE_DELAY_MS);
  }

  /** The page may close: notes changes that are not written yet synchronously, then writes them. */
  flush(): void {
    const { waiting: id } = this;
    if (id === null || (!this.timer && this.writes === 0)) return;
    this.stopWaiting();
    const state = this.parts.store.get();
    const before = this.kept.get(id);
    if (before && state.project === id && before.poses === this.added)
      this.lastState.note({ id, version: before.version, poses: before.poses, state });
    this.keep(id);
  }

  /** Projects of earlier visits: this tab's first, then by last change. Errors are not fatal. */
  async recall(): Promise<readonly ProjectOnShelf[]> {
    const setAside = await within(RECALL_MS, this.readList()).catch(() => 0);
    if (setAside) this.parts.say('The files remembered by an earlier visit can no longer be read. Open them again.');
    const [ofTab, left] = [readSetting(OF_TAB, 'tab'), readSetting(LEFT)];
    const [own, others] = [this.shelf.filter(({ id }) => id === ofTab), this.shelf.filter(({ id }) => id !== ofTab)];
    return [...own, ...others].map((project) => ({ ...project, opening: project.opening && left !== project.id }));
  }

  /**
   * Opens a stored project through `open`, which resolves to null if another request replaced it. If opening fails or
   * the visit ends first, the project is marked. The next visit does not open a marked project by itself.
   */
  async reopen(id: string, open: (remembered: StoredProject) => Promise<boolean | null>): Promise<boolean> {
    const project = await this.storage.readProject(id);
    if (!project) {
      this.giveUp(id);
      throw new Error('These files are no longer stored, or cannot be read. Open them again.');
    }
    const { remembered, version } = project;
    const leave = (): void => writeSetting(LEFT, id);
    writeSetting(LEFT, null);
    window.addEventListener('pagehide', leave);
    await this.storage.markOpening(id, true).catch(() => undefined);
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
    if (opened !== false) await this.storage.markOpening(id, false).catch(() => undefined);
    window.removeEventListener('pagehide', leave);
    this.tellChange();
    return opened === true;
  }

  /** Removes all stored files, as if nothing had ever been stored. */
  async forgetAll(): Promise<void> {
    this.stopWaiting();
    window.clearTimeout(this.telling);
    await this.saving;
    await this.readList();
    for (const { id } of this.shelf) await this.storage.forgetProject(id);
    this.kept.clear();
    this.dropped.clear();
    this.shelf = [];
    this.told = false;
    this.setNewest(null);
    this.lastState.forget();
    for (const key of [LEFT, UNWANTED]) writeSetting(key, null);
    this.tellChange();
  }

  /** Whether closing the page now would lose work. */
  get unsaved(): boolean {
    const { store, workspace } = this.parts;
    const { source, doc } = store.get();
    const { pool } = workspace;
    const edited = store.history().past.length > 0;
    if (source.kind === 'files') return this.isKept ? this.added > this.kept.get(this.own!)!.poses : edited;
    // A link stores everything about a sample except added poses.
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

  /** Number of poses that are not from the files. */
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

  /** Resolves to the number of unreadable projects. */
  private async readList(): Promise<number> {
    const { projects, setAside } = await this.storage.readShelf();
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
    await this.storage.forgetProject(id);
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
      this.telling = window.setTimeout(() => this.own === id && this.parts.say(KEPT), TELL_DELAY_MS);
    });
  }

  private stopWaiting(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
  }

  /** Writes in sequence, so newer states are never overwritten by older ones. */
  private writeInTurn(id: string): Promise<void> {
    this.writes++;
    this.saving = this.saving
      .then(() => this.write(id))
      .catch(() => {
        const lost = this.kept.has(id);
        this.dropped.add(id);
        this.kept.delete(id);
        this.tellChange();
        this.parts.onError(new Error(lost ? NOT_WRITTEN : NO_ROOM));
      })
      .finally(() => void this.writes--);
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
      const version = await this.storage.keepProject(id, { files, ...changing });
      if (this.dropped.has(id)) return this.storage.forgetProject(id);
      wrote(version);
      await this.readList();
      return;
    }
    if (before.state === text && this.newest === id) return;
    const version = await this.storage.updateProject(id, before.version, changing);
    if (version === null) return this.branch(id);
    wrote(version);
    this.lastState.written(id, text);
  }

  /** Writes a copy with a new id if another tab has written since, so both versions remain. */
  private async branch(id: string): Promise<void> {
    if (this.dropped.has(id)) return;
    this.kept.delete(id);
    const other = this.storage.newProjectId();
    this.parts.store.set({ project: other });
    this.parts.say('Another tab also changed these files. Both versions were kept.');
    await this.write(other);
  }
}

function within<T>(ms: number, work: Promise<T>): Promise<T | null> {
  return Promise.race([work, new Promise<null>((resolve) => setTimeout(resolve, ms, null))]);
}
