/** Synchronous note of a project's last state, because the page may close before the state is stored. */
import type { AppState } from '../../model/state.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';

interface Note {
  id: string;
  /** Version of the project without this state. */
  version: number;
  poses: number;
  state: AppState;
}

const NOTE = 'shapespline.last-state';

export class LastState {
  /** This visit's note, as text, until the state is stored. */
  private noted: string | null = null;

  note(note: Note): void {
    writeSetting(NOTE, JSON.stringify(note));
    this.noted = JSON.stringify(note.state);
  }

  /** Call when this state of the project, as text, is stored. */
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

/** The last visit's note of a project, unless that state was stored. */
export function notedState(id: string, version: number, poses: number): AppState | null {
  const note = readNote();
  if (note?.id !== id || note.poses !== poses) return null;
  // A write in progress at that time may have completed since.
  return version === note.version || version === note.version + 1 ? note.state : null;
}

function readNote(): Note | null {
  try {
    return JSON.parse(readSetting(NOTE) ?? 'null') as Note | null;
  } catch {
    return null;
  }
}
