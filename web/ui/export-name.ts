/** Names of exported files. */
import { clipName } from '../engine/api/clip-name.ts';
import { modelName } from '../engine/api/paths.ts';
import type { KeysInfo } from '../engine/api/types.ts';
import type { Source } from '../model/state.ts';
import { leadingName } from './dropped-files.ts';

/** Suffix of exports, so an export of the user's files does not replace them. */
const MOTION = '-motion';

/** Without extension: the sample, or the files and the animation of the keys. */
export function exportName(source: Source, info: KeysInfo | null): string {
  if (source.kind === 'sample') return source.id;
  const stem = safeName(modelName(source.kind === 'files' ? leadingName(source.names) : '')) || 'shapespline';
  const clip = safeName((info && clipName(info)) ?? '');
  // An export that was opened again keeps its name.
  if (stem.endsWith(MOTION) || (info?.project && clip && stem.endsWith(`-${clip}`))) return stem;
  return clip === '' || info?.project || stem.includes(clip) ? stem + MOTION : `${stem}-${clip}`;
}

/** Removes characters that file systems refuse. */
export const safeName = (name: string): string =>
  name
    .replace(/[/\\\p{C}]/gu, '')
    .replace(/[<>:"|?*]/g, '-')
    .slice(0, 100);
