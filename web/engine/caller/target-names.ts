/** Names of exported morph targets (shape keys in other programs): key names and times. */
import type { PlannedFrames } from './export-source.ts';

/** Blender's limit for shape key names, in bytes. */
const MAX_BYTES = 63;

/** The name followed by the time, with the name shortened to fit. */
function named(name: string, at: string): string {
  const bytes = (text: string): number => new TextEncoder().encode(text).length;
  const letters = [...name];
  while (letters.length > 0 && bytes(`${letters.join('')} ${at}`) > MAX_BYTES) letters.pop();
  return `${letters.join('')} ${at}`;
}

const time = (t: number): string => `t=${Number(t.toFixed(4))}`;

/** Names of all shapes except the first, which is the mesh itself. */
export function targetNames(
  names: readonly string[],
  keyTimes: readonly number[],
  { principal, times, stills, poses }: PlannedFrames,
): string[] {
  const nameAt = (t: number): string => {
    const key = keyTimes.indexOf(t);
    return key < 0 ? time(t) : named(names[key]!, time(t));
  };
  const given = names.slice(0, poses).map((name) => named(name, 'as given'));
  if (!principal) return [...[...times, ...stills].slice(1).map(nameAt), ...given];
  const corrections = Array.from({ length: principal.corrections }, (_, index) => `in-between ${index + 1}`);
  return [...keyTimes.slice(1).map(nameAt), ...corrections];
}
