/**
 * A request to open content, as plain data: a sample, a link, picked files, earlier content, or the open files again.
 */
import { IMPORT } from '../../engine/api/option-table.ts';
import { extensionOf, isModel } from '../../engine/api/paths.ts';
import type { ImportOptions, InputFile } from '../../engine/api/types.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { Doc, Source } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Step } from '../storage/open-history.ts';
import type { StoredProject } from '../storage/project-shelf.ts';
import type { Snapshot } from '../storage/snapshot.ts';
import type { Turn } from '../session/store.ts';
import type { Input } from '../session/workspace.ts';
import { readFiles } from './input-files.ts';
import type { Permalink } from './permalink.ts';
import { readingOf } from './samples.ts';
import type { Sample } from './samples.ts';

export interface OpenRequest {
  input: Input;
  /** Import options. */
  options: ImportOptions;
  source: Source;
  /** The project of the user's files; null for a new one. */
  project: string | null;
  /** The history step for undo; null for none. */
  step: Step | null;
  /** The initial document follows the rules for a sample or for files; absent: unchanged from the import. */
  begins?: Sample | 'files';
  link?: Permalink | null;
  /** The user has just picked the files and chosen no options. Shapes that seem to lie down are stood up. */
  picked?: boolean;
  /** Content to restore exactly. */
  left?: StoredProject | Snapshot;
  /** The document that provides the settings. */
  settings?: Doc;
  /** The mesh is the same, so time, view and playback stay. */
  stays?: boolean;
  /** The files have another orientation; document and history stay. */
  turn?: Turn;
}

/** The open content: files, import options and state. */
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

/** Dropped or chosen files are the keys of a motion. */
export function pickedRequest(files: readonly PickedFile[]): OpenRequest {
  const source: Source = { kind: 'files', names: files.map(({ name }) => name) };
  const input: Input = (report, signal) => readFiles(files, report, signal);
  return { input, options: {}, source, project: null, step: 'on', begins: 'files', picked: true };
}

/** Restores content of an earlier visit, or of this one. */
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

/** Samples the keys again at these times of the animation's own timeline, in seconds. */
export function momentsRequest(present: Present, animation: number, times: number[]): OpenRequest {
  return { ...readAgain(present, { animation, sample: times }), stays: true };
}

/** Takes the keys from the files' own animation, at the default times. */
export function animationRequest(present: Present): OpenRequest {
  return { ...readAgain(present, { animation: 0 }), stays: true, begins: 'files' };
}

/** Uses only these objects of the files; an empty list means all. */
export function objectsRequest(present: Present, objects: string[]): OpenRequest {
  const { animation, sample } = present.options;
  return readAgain(present, { animation, sample, objects: objects.length > 0 ? objects : undefined });
}

/** Reads the files again with the same orientation. */
function readAgain({ files, options, state }: Present, change: ImportOptions): OpenRequest {
  const { up, unit, objects } = options;
  const { source, project, doc } = state;
  const read = { up, unit, objects, ...change };
  return { input: files, options: read, source, project, step: 'on', settings: doc };
}

/** Uses another up axis or unit. */
export function turnRequest({ files, options, state }: Present, after: Orientation, step: Step | null): OpenRequest {
  const { source, project } = state;
  const turn = { before: orientationOf(files, options) ?? after, after };
  return { input: files, options: { ...options, ...after }, source, project, step, stays: true, turn };
}

/** glTF defines up axis and unit; the other formats do not. */
export function orientationOf(
  input: readonly InputFile[],
  { up = IMPORT.up.default, unit = IMPORT.unit.default }: ImportOptions,
): Orientation | null {
  return input.some(({ name }) => !['glb', 'gltf'].includes(extensionOf(name)) && isModel(name)) ? { up, unit } : null;
}
