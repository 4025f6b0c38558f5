/** The last state of a project, noted where that takes no time: the page may be left before it is written. */
import type { AppState } from '../../model/state.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';

interface Note {
  id: string;
  /** Of the project, to which the state was not written yet. */
  version: number;
  poses: number;
  state: AppState;
}

const NOTE = 'shapespline.last-state';

export class LastState {
  /** What this visit has noted, as text, until it is written. */
  private noted: string | null = null;

  note(note: Note): void {
    writeSetting(NOTE, JSON.stringify(note));
    this.noted = JSON.stringify(note.state);
  }

  /** This state of the project, as text, is written. */
  written(id: string, state: string): void {
    if (this.noted !== null && state !== this.noted) return;
    this.noted = null;
    if (readNote()?.id === id) writeSetting(NOTE, null);
  }

  forget(): void {
    this.noted = null;
    writeSetting(NOTE, null);
  }
}

/** What the last visit noted of a project as it was left, unless it was written after all. */
export function notedState(id: string, version: number, poses: number): AppState | null {
  const note = readNote();
  if (note?.id !== id || note.poses !== poses) return null;
  // A write that was under way then may have ended since.
  return version === note.version || version === note.version + 1 ? note.state : null;
}

function readNote(): Note | null {
  try {
    return JSON.parse(readSetting(NOTE) ?? 'null') as Note | null;
  } catch {
    return null;
  }
}
