/** Synchronous notes of the projects' last states, because the page may close before the states are stored. */
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Changing, StoredProject } from './project-shelf.ts';
import { newProjectId } from './project-shelf.ts';

/** The state that a tab last had of a project. */
interface LastState extends Pick<Changing, 'state' | 'options'> {
  /** The stored version that it follows; null before the first. */
  version: number | null;
  /** The content that the tab was writing at that time, as text; null for none. */
  writing: string | null;
  /** The project that the tab was writing this state to, because another tab had changed this one. */
  copy: string | undefined;
  /** Number of poses, which are not part of the note. */
  poses: number;
}

export interface Note extends LastState {
  id: string;
  /** The tab that wrote it; earlier versions of the page had one note for all tabs. */
  tab?: string;
}

/** The notes of a project, applied to its stored version. */
export interface Left {
  /** The state that follows the stored version, if any. */
  last: StoredProject | null;
  /** The states of other tabs. They follow an earlier version. */
  others: { project: StoredProject; note: Note }[];
}

const NOTES = 'shapespline.last-state';
const MAX_NOTES = 12;

export class LastStates {
  private readonly tab = newProjectId();
  private readonly own = new Map<string, Note>();

  note(id: string, last: LastState): void {
    const note = { ...last, id, tab: this.tab };
    this.own.set(id, note);
    write([...readNotes().filter((one) => !sameNote(one, note)), note]);
  }

  /** This tab's note of a project. */
  of(id: string): Note | undefined {
    return this.own.get(id);
  }

  /** Call when the state of this note is stored, or a later one. */
  written(id: string, note: Note | undefined): void {
    if (!note || this.own.get(id) !== note) return;
    this.own.delete(id);
    this.claim(note);
  }

  /** Removes the notes of a project, or all. */
  forget(id?: string): void {
    if (id === undefined) this.own.clear();
    else this.own.delete(id);
    write(id === undefined ? [] : readNotes().filter((one) => one.id !== id));
  }

  /** Applies all tabs' notes of a project to its stored version. The note that follows it is this tab's from now on. */
  left(id: string, version: number, stored: StoredProject): Left {
    const text = contentText(stored);
    const count = stored.poses.length;
    const follows = (note: Note): boolean =>
      note.poses === count && (note.version === version || note.writing === text);
    const project = ({ state, options = stored.options, poses }: Note): StoredProject => ({
      ...stored,
      state,
      // Poses are stored with the orientation of their options, and are only ever appended.
      options: count === 0 ? options : stored.options,
      poses: stored.poses.slice(0, poses),
    });
    const notes = readNotes().filter((note) => note.id === id && note.poses <= count);
    const last = notes.findLast(follows);
    const others = notes
      .filter((note) => note !== last && note.tab !== undefined)
      .map((note) => ({ project: project(note), note }))
      .filter((other) => contentText(other.project) !== text);
    write(readNotes().filter((note) => note.id !== id || others.some((other) => sameNote(other.note, note))));
    if (last) this.note(id, last);
    return { last: last ? project(last) : null, others };
  }

  /** Removes another tab's note. False if it is gone, because a third tab has taken it. */
  claim(note: Note): boolean {
    const notes = readNotes();
    const left = notes.filter((one) => !sameNote(one, note));
    write(left);
    return left.length < notes.length;
  }

  putBack(note: Note): void {
    write([...readNotes(), note]);
  }
}

/** A tab has one note of each project. */
const sameNote = (a: Note, b: Note): boolean => a.id === b.id && a.tab === b.tab;

/** The part of a project that edits change, without its poses. Equal texts mean equal content. */
export function contentText({ state, options }: Pick<Changing, 'state' | 'options'>): string {
  return JSON.stringify([state, options]);
}

function write(notes: Note[]): void {
  writeSetting(NOTES, notes.length > 0 ? JSON.stringify(notes.slice(-MAX_NOTES)) : null);
}

function readNotes(): Note[] {
  try {
    const notes = JSON.parse(readSetting(NOTES) ?? '[]') as Note | Note[] | null;
    return [notes ?? []].flat();
  } catch {
    return [];
  }
}
