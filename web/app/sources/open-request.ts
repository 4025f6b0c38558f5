/** What is to be open, as plain data: of a sample and a link, picked files, what was left, or the open files again. */
import { IMPORT } from '../../engine/api/option-table.ts';
import { extensionOf, isModel } from '../../engine/api/paths.ts';
import type { ImportOptions, InputFile } from '../../engine/api/types.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { Doc, Source } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Step } from '../kept/open-history.ts';
import type { StoredProject } from '../kept/project-shelf.ts';
import type { Snapshot } from '../kept/snapshot.ts';
import type { Turn } from '../session/store.ts';
import type { Input } from '../session/workspace.ts';
import { readFiles } from './input-files.ts';
import type { Permalink } from './permalink.ts';
import { readingOf } from './samples.ts';
import type { Sample } from './samples.ts';

export interface OpenRequest {
  input: Input;
  /** How it is read. */
  options: ImportOptions;
  source: Source;
  /** Of files of the user; null: a new one. */
  project: string | null;
  /** What undo goes back over; null: nothing. */
  step: Step | null;
  /** The document begins as one of a sample or of files does; absent: as it is read. */
  begins?: Sample | 'files';
  link?: Permalink | null;
  /** By the user just now, who has chosen nothing about them yet: shapes that seem to lie are stood up. */
  picked?: boolean;
  /** Restored exactly as it was left. */
  left?: StoredProject | Snapshot;
  /** The document that settings are taken from. */
  settings?: Doc;
  /** The same mesh: time, view and playing go on. */
  stays?: boolean;
  /** The files lie otherwise: the document stays, and its history. */
  turn?: Turn;
}

/** What is open: its files, how they were read, and its state. */
export type Present = Pick<Snapshot, 'files' | 'options' | 'state'>;

export function sampleRequest(
  sample: Sample,
  input: InputFile[],
  link: Permalink | null,
  step: Step | null,
): OpenRequest {
  const options = readingOf(sample);
  return { input, options, source: { kind: 'sample', id: sample.id }, project: null, step, begins: sample, link };
}

/** Files that were dropped or chosen are the keys of a motion. */
export function pickedRequest(files: readonly PickedFile[]): OpenRequest {
  const source: Source = { kind: 'files', names: files.map(({ name }) => name) };
  const input: Input = (report, signal) => readFiles(files, report, signal);
  return { input, options: {}, source, project: null, step: 'on', begins: 'files', picked: true };
}

/** By an earlier visit, or by this one for something else. */
export function leftRequest(
  left: StoredProject | Snapshot,
  samples: readonly Sample[],
  step: Step | null,
): OpenRequest {
  const { files, options, state } = left;
  const { source, project } = state;
  const sample = source.kind === 'sample' ? samples.find(({ id }) => id === source.id) : undefined;
  return { input: files, options, source, project, step, begins: sample ?? 'files', left };
}

/** Takes the keys again, at these seconds of the animation's own timeline. */
export function momentsRequest(present: Present, animation: number, times: number[]): OpenRequest {
  return { ...readAgain(present, { animation, sample: times }), stays: true };
}

/** Takes the keys from the files' own animation, at the default times. */
export function animationRequest(present: Present): OpenRequest {
  return { ...readAgain(present, { animation: 0 }), stays: true, begins: 'files' };
}

/** Of these objects of the files; with none, of all of them. */
export function objectsRequest(present: Present, objects: string[]): OpenRequest {
  const { animation, sample } = present.options;
  return readAgain(present, { animation, sample, objects: objects.length > 0 ? objects : undefined });
}

/** Lying as they were said to lie. */
function readAgain({ files, options, state }: Present, change: ImportOptions): OpenRequest {
  const { up, unit, objects } = options;
  const { source, project, doc } = state;
  const read = { up, unit, objects, ...change };
  return { input: files, options: read, source, project, step: 'on', settings: doc };
}

/** With another axis up or another unit. */
export function turnRequest({ files, options, state }: Present, after: Orientation, step: Step | null): OpenRequest {
  const { source, project } = state;
  const turn = { before: orientationOf(files, options) ?? after, after };
  return { input: files, options: { ...options, ...after }, source, project, step, stays: true, turn };
}

/** glTF says which way is up and how long a metre is; the other formats do not. */
export function orientationOf(
  input: readonly InputFile[],
  { up = IMPORT.up.default, unit = IMPORT.unit.default }: ImportOptions,
): Orientation | null {
  return input.some(({ name }) => !['glb', 'gltf'].includes(extensionOf(name)) && isModel(name)) ? { up, unit } : null;
}
