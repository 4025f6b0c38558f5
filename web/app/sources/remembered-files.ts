/** The user's own files, kept in this browser between visits where the user has asked for it. They are sent nowhere. */
import { clear, createStore, get, setMany } from 'idb-keyval';
import type { ImportOptions, InputFile } from '../../engine/api/types.ts';
import type { AppState } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { NewPose } from './input-files.ts';

/** Everything that opens the files again as they were left. */
export interface Remembered {
  files: InputFile[];
  options: ImportOptions;
  /** Poses that are not of the files: taken from shapes, or from further files. */
  poses: NewPose[];
  state: AppState;
}

export interface RememberedFilesParts {
  store: Store;
  workspace: Workspace;
  /** Whether the files are kept for the next visit. */
  onChange(remembered: boolean): void;
  say(text: string): void;
  onError(error: unknown): void;
}

export interface RememberedFiles {
  /** Remembers what is open, or forgets everything. */
  toggle(): Promise<void>;
  /** The state has changed. */
  follow(): void;
  /** What an earlier visit left, or null. */
  recall(): Promise<Remembered | null>;
}

const SAVE_DELAY_MS = 500;
/** Raised when older visits can no longer be read. */
const FORMAT = 1;

export function createRememberedFiles({
  store,
  workspace,
  onChange,
  say,
  onError,
}: RememberedFilesParts): RememberedFiles {
  const shelf = createStore('shapespline', 'remembered');
  let saved: InputFile[] | null = null;
  let timer = 0;
  let remembered = false;

  const change = (now: boolean): void => {
    remembered = now;
    onChange(now);
  };

  const save = async (): Promise<void> => {
    const state = store.get();
    const { input, options, pool } = workspace;
    if (!pool || state.source.kind !== 'files') return;
    const poses = Array.from({ length: pool.count - pool.imported }, (_, index) => pool.imported + index).map(
      (pose) => ({ name: pool.keys.info.names[pose] ?? '', positions: pool.keys.positions(pose) }),
    );
    // Files may be large: they are written once, the state with every change.
    const files: [string, unknown][] =
      input === saved
        ? []
        : [
            ['files', input],
            ['format', FORMAT],
          ];
    await setMany([...files, ['rest', { options, poses, state }]], shelf);
    saved = input;
  };

  const forget = async (): Promise<void> => {
    window.clearTimeout(timer);
    saved = null;
    change(false);
    await clear(shelf);
  };

  return {
    async toggle() {
      if (remembered) {
        await forget();
        say('Forgotten: the next visit starts with a sample.');
        return;
      }
      try {
        await save();
        change(true);
        say('Remembered on this computer: the next visit starts with these files.');
      } catch {
        await forget().catch(() => undefined);
        onError(
          new Error(
            'This browser has no room for these files, or keeps nothing in a private window. Export saves them as a project.',
          ),
        );
      }
    },
    follow() {
      if (!remembered) return;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => void save().catch(() => forget().catch(onError)), SAVE_DELAY_MS);
    },
    async recall() {
      // A browser that keeps nothing has nothing to recall.
      const [format, files, rest] = await Promise.all(
        ['format', 'files', 'rest'].map((key) => get<unknown>(key, shelf)),
      ).catch(() => []);
      if (format !== FORMAT || !files || !rest) return null;
      change(true);
      return { files: files as InputFile[], ...(rest as Omit<Remembered, 'files'>) };
    },
  };
}
