/**
 * What is meant by picked files: the keys of a motion, a further pose of the mesh that is open, or the first pose of a
 * motion, which waits for the next.
 */
import { EngineError } from '../../engine/api/errors.ts';
import { sequenceText, sequencesIn } from '../../engine/api/numbered-names.ts';
import { fileName, isModel, withoutLeftovers } from '../../engine/api/paths.ts';
import { isMismatch } from '../../engine/api/read-poses.ts';
import type { Offer } from '../../ui/messages.ts';
import type { Source } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import type { Store } from '../session/store.ts';
import type { Opener } from './opener.ts';

export interface TakeFilesParts {
  store: Store;
  files: Opener;
  say(text: string): void;
  /** What waits for the user's word; null: nothing any more. */
  onOffer(offer: Offer | null): void;
  /** Has the user choose further files. */
  onPick(): void;
}

export interface TakeFiles {
  /** `place`: before which key they were put down, or null where they were not put among the keys. */
  take(picked: PickedFile[] | Promise<PickedFile[]>, place?: number | null): Promise<void>;
  /** Something else was opened: no pose waits any more. */
  forget(): void;
}

export function createTakeFiles({ store, files, say, onOffer, onPick }: TakeFilesParts): TakeFiles {
  let waiting: readonly PickedFile[] = [];

  const wait = (first: readonly PickedFile[]): void => {
    waiting = first;
    onOffer({
      message: `${titleOf(first)} is the first pose. Drop the next one, or choose it.`,
      action: 'Choose files',
      onAccept: onPick,
      onDecline: () => (waiting = []),
    });
  };

  const forget = (): void => {
    waiting = [];
    onOffer(null);
  };

  const done = (opened: boolean): boolean => {
    if (opened) forget();
    return opened;
  };

  /** The pose that the files hold, as a key of what is open; false where it is of another mesh. */
  const add = async (picked: readonly PickedFile[], place: number | null): Promise<boolean> => {
    try {
      const count = await files.addPoses(picked, place);
      if (count === 1) say(`${titleOf(picked)} was added as a key.`);
      else if (count !== null) say(`${count} keys were added.`);
      return done(count !== null);
    } catch (error) {
      if (!isMismatch(error)) throw error;
      return false;
    }
  };

  /** Work of the user's own is replaced only where that is meant. */
  const askInstead = (picked: readonly PickedFile[], start: () => void): boolean => {
    const several = picked.filter(({ name }) => isModel(name)).length > 1;
    onOffer({
      message: `${titleOf(picked)}${several ? ' and the others are' : ' is'} of another mesh than what is open.`,
      action: 'Open it instead',
      onAccept: start,
    });
    return false;
  };

  const orElse = async (picked: readonly PickedFile[], error: unknown): Promise<boolean> => {
    if (waiting.length > 0) {
      // The new files may be a motion without the pose that waits.
      const opened = await files.open(picked).catch(() => false);
      if (!done(opened)) throw error;
      return true;
    }
    if (!isSinglePose(error)) throw error;
    if (await add(picked, null)) return true;
    if (store.get().source.kind === 'files') return askInstead(picked, () => wait(picked));
    wait(picked);
    return false;
  };

  const open = (picked: readonly PickedFile[]): Promise<boolean> =>
    files.open([...waiting, ...picked]).then(done, (error: unknown) => orElse(picked, error));

  const take = async (picked: readonly PickedFile[], place: number | null): Promise<boolean> => {
    if (place !== null && waiting.length === 0) {
      if (await add(picked, place)) return true;
      return askInstead(picked, () => void files.run([...picked], (taken) => take(taken, null)));
    }
    if (waiting.length === 0 && areFurtherPoses(picked, store.get().source)) {
      if (await add(picked, null)) return true;
      if (store.get().source.kind === 'files') return askInstead(picked, () => void files.run([...picked], open));
    }
    return open(picked);
  };

  /** Of several numbered sequences one is meant, or the files are keys after all. */
  const askWhich = (picked: readonly PickedFile[], place: number | null): boolean => {
    const sequences = sequencesIn(picked.map(({ name }) => name));
    if (sequences.length < 2) return false;
    const open = (chosen: PickedFile[]): void => void files.run(chosen, (taken) => take(taken, place));
    const choices = sequences.slice(0, MOST_CHOICES).map((sequence) => ({
      action: sequenceText(sequence),
      onAccept: () => open(picked.filter(({ name }) => !isModel(name) || sequence.names.includes(name))),
    }));
    const all = { action: 'All of them', onAccept: () => open([...picked]) };
    const [first, ...others] = [...choices, all];
    const more = sequences.length > choices.length ? `, of which ${choices.length} are shown` : '';
    onOffer({
      message: `There are ${sequences.length} numbered sequences${more}. Which one do you want to open?`,
      ...first,
      others,
    });
    return true;
  };

  return {
    forget,
    async take(picked, place = null) {
      await files.run(picked, async (all) => {
        const taken = withoutLeftovers(all);
        return !askWhich(taken, place) && take(taken, place);
      });
    },
  };
}

const MOST_CHOICES = 4;

/** More numbered files than this are an animation. */
const MOST_POSES = 32;

/** A few files of one pose each that are not among those that are open, which are a motion of the user's own. */
function areFurtherPoses(picked: readonly PickedFile[], source: Source): boolean {
  const models = picked.map(({ name }) => name).filter(isModel);
  const known = source.kind === 'files' ? source.names : models;
  return models.length > 1 && models.length <= MOST_POSES && !models.some((name) => known.includes(name));
}

function titleOf(picked: readonly PickedFile[]): string {
  return `“${fileName(leadingName(picked.map(({ name }) => name)))}”`;
}

function isSinglePose(error: unknown): boolean {
  return error instanceof EngineError && error.code === 'too-few-keys';
}
