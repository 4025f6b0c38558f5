/** Names of exported morph targets, which arrive as shape keys: names of keys, and times. */
import type { PlannedFrames } from './export-source.ts';

/** Bytes that Blender keeps of a shape key's name. */
const MOST_BYTES = 63;

/** The name before the time, shortened to fit. */
function named(name: string, at: string): string {
  const bytes = (text: string): number => new TextEncoder().encode(text).length;
  const letters = [...name];
  while (letters.length > 0 && bytes(`${letters.join('')} ${at}`) > MOST_BYTES) letters.pop();
  return `${letters.join('')} ${at}`;
}

const time = (t: number): string => `t=${Number(t.toFixed(4))}`;

/** For all shapes but the first, which is the mesh itself. */
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
