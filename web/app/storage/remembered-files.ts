/**
 * Stores the user's files and edits in this browser between visits, unless the user declines. They are never uploaded.
 */
import type { InputFile } from '../../engine/api/types.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { LastStates, contentText } from './last-state.ts';
import * as browserShelf from './project-shelf.ts';
import type { ProjectOnShelf, StoredProject } from './project-shelf.ts';
import { bytesOf, currentSnapshot } from './snapshot.ts';
import type { Snapshot } from './snapshot.ts';

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

type ProjectStorage = Omit<typeof browserShelf, 'readRecord' | 'areFiles' | 'onDeleted'> &
  Partial<Pick<typeof browserShelf, 'onDeleted'>>;

/** This visit's knowledge of a stored project. */
interface Kept {
  version: number;
  /** Number of poses that are not from the files. */
  poses: number;
  files: InputFile[];
  /** The stored content as text; null if unknown. */
  content: string | null;
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
const BOTH_KEPT = 'Another tab also changed these files. Both versions were kept.';
const NOT_WRITTEN =
  'The last change could not be stored: this browser has no room for it. The previous version is kept. Export a GLB to save the project.';

export class RememberedFiles {
  private readonly tabs =
    typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel('shapespline remembered files');
  private readonly kept = new Map<string, Kept>();
  /** Projects that are not written: forgotten by the user, or without room. */
  private readonly dropped = new Set<string>();
  private readonly lastStates = new LastStates();
  /** The last content of projects that is or was not stored. Other files may be open by the time it is written. */
  private readonly contents = new Map<string, Snapshot>();
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
  /** The new projects of those that another tab has changed. */
  private readonly copies = new Map<string, string>();
  /** The content that is being written. */
  private writing: { id: string; content: string } | null = null;
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
    this.storage.onDeleted?.(() => this.storeAgain());
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
    if (id !== this.waiting) this.leave();
    if (id === null || this.dropped.has(id) || !this.isWanted) return;
    this.take(id);
    // A new pose is written immediately, because leaving the page would lose it.
    const atOnce = this.isKept && this.kept.get(id)!.poses !== this.added;
    if (atOnce) this.stopWaiting();
    if (this.timer) return;
    this.waiting = id;
    this.timer = window.setTimeout(() => this.keep(id), atOnce ? 0 : SAVE_DELAY_MS);
  }

  /** The page may close: notes changes that are not written yet synchronously, then writes them. */
  flush(): void {
    const { waiting: id } = this;
    if (id === null || (!this.timer && this.writes === 0)) return;
    this.stopWaiting();
    if (this.own === id) this.take(id);
    for (const [project, snapshot] of this.contents) this.note(project, snapshot);
    this.keep(id);
  }

  /** Resolves when all changes are stored, or could not be. */
  async settle(): Promise<void> {
    this.flush();
    await within(RECALL_MS, this.saving);
  }

  /** Notes content that is not stored, unless its poses or its files are not stored either. */
  private note(id: string, { state, options, poses }: Snapshot): void {
    const before = this.kept.get(id);
    const writing = this.writing?.id === id ? this.writing.content : null;
    const { version = null, poses: stored = poses.length, content = null } = before ?? {};
    if ((!before && !writing) || stored !== poses.length || content === contentText({ state, options })) return;
    this.lastStates.note(id, { version, writing, copy: this.copies.get(id), poses: stored, state, options });
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
    this.leave();
    if (this.contents.has(id)) await this.saving;
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
    const { files, poses } = remembered;
    const kept = { version, poses: poses.length, files, content: null };
    this.kept.set(id, kept);
    this.told = true;
    const { last, others } = this.lastStates.left(id, version, remembered);
    const start = last ?? remembered;
    const opened = await open({ ...start, state: { ...start.state, project: id } });
    if (opened) {
      const now = last ? null : currentSnapshot(this.parts.store, this.parts.workspace);
      this.kept.set(id, { ...kept, content: now && contentText(now) });
      this.setNewest(id);
    }
    if (opened && others.length > 0) await this.readList().catch(() => undefined);
    for (const { project: other, note } of opened ? others : [])
      if (this.lastStates.claim(note) && !this.shelf.some((one) => one.id === note.copy))
        await this.storeBeside(other).catch(() => this.lastStates.putBack(note));
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
    for (const known of [this.kept, this.dropped, this.contents]) known.clear();
    this.shelf = [];
    this.told = false;
    this.setNewest(null);
    this.lastStates.forget();
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
    return this.isStored(this.own ?? '');
  }

  private isStored(id: string): boolean {
    return this.kept.has(id) && !this.dropped.has(id);
  }

  /** Takes the open content of this project for the next write. */
  private take(id: string): void {
    const snapshot = currentSnapshot(this.parts.store, this.parts.workspace);
    if (snapshot) this.contents.set(id, snapshot);
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
    this.contents.delete(id);
    this.dropped.add(id);
    this.shelf = this.shelf.filter((project) => project.id !== id);
    this.tellChange();
  }

  private async forget(id: string): Promise<void> {
    this.giveUp(id);
    writeSetting(UNWANTED, 'yes');
    this.lastStates.forget(id);
    await this.saving;
    await this.storage.forgetProject(id);
    this.tabs?.postMessage({ forgotten: id });
    this.parts.say('Forgotten. Files are no longer remembered.');
  }

  private async remember(id: string): Promise<void> {
    this.dropped.delete(id);
    writeSetting(UNWANTED, null);
    this.take(id);
    await this.writeInTurn(id);
    if (this.isStored(id)) this.parts.say('Remembered on this computer: the next visit starts with these files.');
  }

  private keep(id: string): void {
    this.timer = 0;
    void this.writeInTurn(id).then(() => {
      if (this.told || !this.isStored(id)) return;
      this.told = true;
      this.telling = window.setTimeout(() => this.own === id && this.parts.say(KEPT), TELL_DELAY_MS);
    });
  }

  /** Other files are open now: writes the last change of those before. */
  private leave(): void {
    const { timer, waiting } = this;
    this.stopWaiting();
    if (timer && waiting !== null) this.keep(waiting);
  }

  /** Another tab has deleted everything. */
  private storeAgain(): void {
    const id = this.own;
    const kept = this.kept.get(id ?? '');
    if (id === null || !kept) return;
    kept.content = null;
    this.take(id);
    this.keep(id);
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
        this.tellChange();
        this.parts.onError(new Error(lost ? NOT_WRITTEN : NO_ROOM));
      })
      .finally(() => void this.writes--);
    return this.saving;
  }

  private async write(id: string): Promise<void> {
    const snapshot = this.contents.get(id);
    if (!snapshot || this.dropped.has(id)) return;
    const [noted, content, before] = [this.lastStates.of(id), contentText(snapshot), this.kept.get(id)];
    const isStored = before?.files === snapshot.files && before.content === content;
    if (!isStored || (this.own === id && this.newest !== id)) {
      this.writing = { id, content };
      const version = await this.store(id, snapshot, before).finally(() => (this.writing = null));
      if (this.dropped.has(id)) return this.storage.forgetProject(id);
      if (version === null) return this.branch(id);
      const { files, poses } = snapshot;
      this.kept.set(id, { version, poses: poses.length, files, content });
      if (this.own === id) this.setNewest(id);
      if (before?.files !== files) await this.readList();
    }
    this.lastStates.written(id, noted);
    if (this.own !== id && this.contents.get(id) === snapshot) this.contents.delete(id);
  }

  /** Resolves to the new version; null if another tab has written something else since. */
  private async store(id: string, snapshot: Snapshot, before: Kept | undefined): Promise<number | null> {
    const { history: _, ...project } = snapshot;
    const { files, ...changing } = project;
    if (before?.files !== files) return this.storage.keepProject(id, project, before?.version ?? null);
    const version = await this.storage.updateProject(id, before.version, changing);
    if (version !== null) return version;
    const now = await this.storage.readProject(id);
    const { poses } = changing;
    if (now) {
      const { remembered } = now;
      return contentText(remembered) === contentText(project) && remembered.poses.length === poses.length
        ? now.version
        : null;
    }
    if (readSetting(UNWANTED) === null) return this.storage.keepProject(id, project, null);
    this.giveUp(id);
    return null;
  }

  /** Writes a copy with a new id if another tab has written since, so both versions remain. */
  private async branch(id: string): Promise<void> {
    const snapshot = this.contents.get(id)!;
    if (this.own !== id) await this.storeBeside(snapshot);
    else {
      const other = this.storage.newProjectId();
      this.copies.set(id, other);
      if (this.lastStates.of(id)) this.note(id, snapshot);
      this.stopWaiting();
      this.waiting = other;
      // A reload of this tab opens its own version, even if the page closes before the write ends.
      this.setNewest(other);
      this.parts.store.set({ project: other });
      this.take(other);
      await this.write(other);
      this.parts.say(BOTH_KEPT);
    }
    if (this.contents.get(id) === snapshot) this.contents.delete(id);
    this.lastStates.written(id, this.lastStates.of(id));
  }

  /** Stores a project that is not open, beside the version of another tab. */
  private async storeBeside({ files, options, poses, offset, state }: StoredProject): Promise<void> {
    const id = this.storage.newProjectId();
    const project = { files, options, poses, ...(offset && { offset }), state: { ...state, project: id } };
    await this.storage.keepProject(id, project, null);
    await this.readList();
    this.parts.say(BOTH_KEPT);
  }
}

function within<T>(ms: number, work: Promise<T>): Promise<T | null> {
  return Promise.race([work, new Promise<null>((resolve) => setTimeout(resolve, ms, null))]);
}
