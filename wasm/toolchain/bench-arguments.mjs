// Parses the arguments of `npm run bench --` before anything is built.
import { parseArgs } from 'node:util';
import { Explained } from './log.mjs';

const USAGE = [
  'usage: npm run bench [-- FACES,FACES,... --browser --save]',
  '       npm run bench -- exports [FACES,... --save]',
  '       npm run bench -- start',
  '       npm run bench -- drop [FACES,...]',
  '       npm run bench -- hold FILE... [--save]',
  'with 64 to 4000000 faces',
].join('\n');

/** What each benchmark takes. */
const TAKES = {
  stages: { sizes: true, browser: true, save: true },
  exports: { sizes: true, save: true },
  start: {},
  drop: { sizes: true },
  hold: { files: true, save: true },
};

/** The benchmark to run, its sizes (null: the default) or files, and whether to run it in a browser. */
export function benchArguments(words) {
  const isNamed = words[0] !== 'stages' && Object.hasOwn(TAKES, words[0] ?? '');
  const what = isNamed ? words[0] : 'stages';
  const takes = TAKES[what];
  const {
    values: { browser = false, save = false },
    positionals,
  } = parsed(words.slice(isNamed ? 1 : 0));
  const files = takes.files ? positionals : [];
  const [list, ...more] = takes.files ? [] : positionals;
  const sizes = list?.split(',').map((text) => ({ faces: /^\d+$/.test(text) ? Number(text) : NaN })) ?? null;
  const good =
    more.length === 0 &&
    (takes.files ? files.length > 0 : true) &&
    (sizes === null || (takes.sizes && sizes.every(({ faces }) => faces >= 64 && faces <= 4_000_000))) &&
    !(save && !takes.save) &&
    !(browser && !takes.browser);
  if (!good) throw new Explained(USAGE);
  return { what, sizes, files, browser, save };
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
