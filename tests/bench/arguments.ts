/** The words behind `npm run bench --`. */
import { parseArgs } from 'node:util';

export const USAGE = [
  'usage: npm run bench [-- FACES,FACES,... --browser --save]',
  '       npm run bench -- threads [FACES,... --browser]',
  '       npm run bench -- ghost [FACES[:KEYS],...]',
  '       npm run bench -- ghost browser [FACES,...]',
  'with 64 to 4000000 faces and 2 to 100 keys',
].join('\n');

export interface Size {
  faces: number;
  /** null where none were given. */
  keys: number | null;
}

export interface Wanted {
  what: 'stages' | 'threads' | 'ghost' | 'ghost browser';
  /** null: the usual ones. */
  sizes: Size[] | null;
  browser: boolean;
  save: boolean;
}

/** null where the words make no sense. */
export function readArguments(words: string[]): Wanted | null {
  const what = words[0] === 'threads' ? 'threads' : words[0] !== 'ghost' ? 'stages' : words[1] === 'browser' ? 'ghost browser' : 'ghost';
  const rest = words.slice({ stages: 0, threads: 1, ghost: 1, 'ghost browser': 2 }[what]);
  try {
    const { values: { browser = false, save = false }, positionals: [list, ...more] } = parseArgs({
      args: rest, allowPositionals: true, options: { browser: { type: 'boolean' }, save: { type: 'boolean' } },
    });
    const sizes = list?.split(',').map(sizeOf) ?? null;
    const good = more.length === 0 && (sizes?.every((size) => isGood(size, what === 'ghost')) ?? true)
      && !(save && what !== 'stages') && !(browser && what.startsWith('ghost'));
    return good ? { what, sizes, browser, save } : null;
  } catch {
    return null;
  }
}

function sizeOf(text: string): Size {
  const [, faces, keys] = /^(\d+)(?::(\d+))?$/.exec(text) ?? [];
  return { faces: Number(faces), keys: keys === undefined ? null : Number(keys) };
}

function isGood({ faces, keys }: Size, mayHaveKeys: boolean): boolean {
  return faces >= 64 && faces <= 4_000_000 && (keys === null || (mayHaveKeys && keys >= 2 && keys <= 100));
}
