// Parses the arguments of `npm run bench --` before anything is built.
import { parseArgs } from 'node:util';
import { Explained } from './log.mjs';

const USAGE = [
  'usage: npm run bench [-- FACES,FACES,... --browser --save]',
  '       npm run bench -- threads [FACES,... --browser]',
  '       npm run bench -- exports [FACES,... --save]',
  '       npm run bench -- ghost [FACES[:KEYS],...]',
  '       npm run bench -- ghost browser [FACES,...]',
  '       npm run bench -- embed [FACES,...]',
  '       npm run bench -- start',
  '       npm run bench -- drop [FACES,...]',
  '       npm run bench -- hold FILE... [--save]',
  '       npm run bench -- inputs [NUMBER] [--save]',
  'with 64 to 4000000 faces and 2 to 100 keys',
].join('\n');

/** The benchmark to run, its sizes (null: the default) or files, and whether to run it in a browser. */
export function benchArguments(words) {
  if (words[0] === 'hold') return withFiles(words);
  if (words[0] === 'inputs') return ofInputs(words);
  const what = ['threads', 'exports', 'embed', 'start', 'drop'].includes(words[0])
    ? words[0]
    : words[0] !== 'ghost'
      ? 'stages'
      : words[1] === 'browser'
        ? 'ghost browser'
        : 'ghost';
  const {
    values: { browser = false, save = false },
    positionals: [list, ...more],
  } = parsed(
    words.slice({ stages: 0, threads: 1, exports: 1, embed: 1, ghost: 1, 'ghost browser': 2, start: 1, drop: 1 }[what]),
  );
  const sizes = list?.split(',').map(sizeOf) ?? null;
  const good =
    more.length === 0 &&
    !(what === 'start' && sizes) &&
    (sizes?.every((size) => isGood(size, what === 'ghost')) ?? true) &&
    !(save && what !== 'stages' && what !== 'exports') &&
    !(browser && (what.startsWith('ghost') || ['exports', 'embed', 'start', 'drop'].includes(what)));
  if (!good) throw new Explained(USAGE);
  return { what, sizes, files: [], browser, save };
}

function withFiles([what, ...words]) {
  const {
    values: { browser = false, save = false },
    positionals: files,
  } = parsed(words);
  if (files.length === 0 || browser) throw new Explained(USAGE);
  return { what, sizes: null, files, browser, save };
}

/** All inputs, or one by its number. */
function ofInputs([what, ...words]) {
  const {
    values: { browser = false, save = false },
    positionals: files,
  } = parsed(words);
  if (browser || files.length > 1 || !files.every((number) => /^\d+$/.test(number))) throw new Explained(USAGE);
  return { what, sizes: null, files, browser, save };
}

function parsed(args) {
  try {
    return parseArgs({
      args,
      allowPositionals: true,
      options: { browser: { type: 'boolean' }, save: { type: 'boolean' } },
    });
  } catch {
    throw new Explained(USAGE);
  }
}

function sizeOf(text) {
  const [, faces, keys] = /^(\d+)(?::(\d+))?$/.exec(text) ?? [];
  return { faces: Number(faces), keys: keys === undefined ? null : Number(keys) };
}

function isGood({ faces, keys }, mayHaveKeys) {
  return faces >= 64 && faces <= 4_000_000 && (keys === null || (mayHaveKeys && keys >= 2 && keys <= 100));
}
