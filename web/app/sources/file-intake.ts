/**
 * Decides how to use picked files. Poses of the open mesh become keys; other files are opened, with undo. A single pose
 * is no motion, so it waits for the next.
 */
import { EngineError } from '../../engine/api/errors.ts';
import { sequenceText, sequencesIn } from '../../engine/api/numbered-names.ts';
import { fileName, isModel, withoutLeftovers } from '../../engine/api/paths.ts';
import { differenceOf, isMismatch } from '../../engine/api/read-poses.ts';
import type { InsertPosition } from '../../model/edits.ts';
import type { Offer } from '../../ui/messages.ts';
import type { Source } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import type { Store } from '../session/store.ts';
import type { Opener } from './opener.ts';

export interface FileIntakeParts {
  store: Store;
  files: Opener;
  say(text: string): void;
  /** The pending offer; null for none. */
  onOffer(offer: Offer | null): void;
  /** Lets the user choose further files. */
  onPick(): void;
}

export class FileIntake {
  /** The first pose of a motion, until the next one arrives. */
  private waiting: readonly PickedFile[] = [];

  constructor(private readonly parts: FileIntakeParts) {}

  /** `place`: drop position among the keys; null if dropped elsewhere. */
  async take(picked: PickedFile[] | Promise<PickedFile[]>, place: InsertPosition | null = null): Promise<void> {
    const { files, onOffer } = this.parts;
    await files.run(picked, async (all) => {
      const importable = withoutLeftovers(all);
      const which = sequencesOffer(importable, (chosen) => void files.run(chosen, (some) => this.takeAll(some, place)));
      if (!which) return this.takeAll(importable, place);
      onOffer(which);
      return false;
    });
  }

  /** Other content was opened, so no pose waits. */
  forget(): void {
    this.waiting = [];
    this.parts.onOffer(null);
  }

  private get hasOwn(): boolean {
    return this.parts.store.get().source.kind === 'files';
  }

  /** A pose of another mesh waits for the next. */
  get waits(): boolean {
    return this.waiting.length > 0;
  }

  private async takeAll(picked: readonly PickedFile[], place: InsertPosition | null): Promise<boolean> {
    // Poses that fit the open mesh do not belong to a waiting pose, which does not fit.
    const mayFit = (this.waits && this.hasOwn) || areFurtherPoses(picked, this.parts.store.get().source);
    if (place === null && !mayFit) return this.open(picked);
    const other = await this.add(picked, place);
    if (!other) return true;
    if (this.hasOwn && countOf(picked) > 1)
      this.parts.say(`${differenceOf(other)} The files are opened as another motion.`);
    return this.open(picked, other);
  }

  /** `other`: the error that they have another mesh. */
  private open(picked: readonly PickedFile[], other: EngineError | null = null): Promise<boolean> {
    return this.parts.files.open([...this.waiting, ...picked]).then(
      (opened) => this.done(opened),
      (error: unknown) => this.orElse(picked, error, other),
    );
  }

  private async orElse(picked: readonly PickedFile[], error: unknown, known: EngineError | null): Promise<boolean> {
    if (this.waits) {
      // The new files may form a motion without the waiting pose, or fit the open mesh.
      const alone = await this.parts.files.open(picked).catch((failure: unknown) => failure);
      if (typeof alone === 'boolean') return this.done(alone);
      if (!isSinglePose(alone)) throw alone;
    } else if (!isSinglePose(error)) throw error;
    const other = known ?? (await this.add(picked, null));
    if (!other) return true;
    if (this.waits) throw this.fitsNeither(other);
    this.wait(picked, other);
    return false;
  }

  /** Adds the files' poses as keys. Resolves to the mismatch error if they have another mesh, else to null. */
  private async add(picked: readonly PickedFile[], place: InsertPosition | null): Promise<EngineError | null> {
    const { files, say } = this.parts;
    try {
      const count = await files.addPoses(picked, place);
      if (count === 1) say(`${titleOf(picked)} was added as a key.`);
      else if (count !== null) say(`${count} keys were added.`);
      this.done(count !== null);
      return null;
    } catch (error) {
      if (!isMismatch(error)) throw error;
      return error;
    }
  }

  private done(opened: boolean): boolean {
    if (opened) this.forget();
    return opened;
  }

  private fitsNeither(other: EngineError): EngineError {
    const waiting = titleOf(this.waiting);
    const message = `${differenceOf(other)} It does not fit ${waiting} either, which waits for its next pose.`;
    return new EngineError(other.code, `${message} Choose a pose of one of them, or press Esc to drop ${waiting}.`);
  }

  private wait(first: readonly PickedFile[], other: EngineError): void {
    const { onOffer, onPick } = this.parts;
    const which = this.hasOwn ? 'another motion' : 'a motion';
    const differs = this.hasOwn ? `${differenceOf(other)} ` : '';
    this.waiting = first;
    onOffer({
      message: `${differs}${titleOf(first)} is the first pose of ${which}. Drop or choose the next pose.`,
      action: 'Choose files',
      onAccept: onPick,
      onDecline: () => (this.waiting = []),
    });
  }
}

const MAX_CHOICES = 4;

/** Offers a choice between several numbered sequences, or all files as keys; null for fewer than two sequences. */
function sequencesOffer(picked: readonly PickedFile[], open: (chosen: PickedFile[]) => void): Offer | null {
  const sequences = sequencesIn(picked.map(({ name }) => name));
  if (sequences.length < 2) return null;
  const choices = sequences.slice(0, MAX_CHOICES).map((sequence) => ({
    action: sequenceText(sequence),
    onAccept: () => open(picked.filter(({ name }) => !isModel(name) || sequence.names.includes(name))),
  }));
  const all = { action: 'All of them', onAccept: () => open([...picked]) };
  const [first, ...others] = [...choices, all];
  const more = sequences.length > choices.length ? `, of which ${choices.length} are shown` : '';
  const message = `There are ${sequences.length} numbered sequences${more}. Which one do you want to open?`;
  return { message, ...first, others };
}

/** More numbered files than this are an animation. */
const MAX_POSES = 32;

/** A few new files of one pose each, added to a motion of the user's own. */
function areFurtherPoses(picked: readonly PickedFile[], source: Source): boolean {
  const models = picked.map(({ name }) => name).filter(isModel);
  const known = source.kind === 'files' ? source.names : models;
  return models.length > 1 && models.length <= MAX_POSES && !models.some((name) => known.includes(name));
}

const countOf = (picked: readonly PickedFile[]): number => picked.filter(({ name }) => isModel(name)).length;

function titleOf(picked: readonly PickedFile[]): string {
  return `“${fileName(leadingName(picked.map(({ name }) => name)))}”`;
}

function isSinglePose(error: unknown): boolean {
  return error instanceof EngineError && error.code === 'too-few-keys';
}
