/**
 * `npm run bench -- inputs`: small files that require much work (`small-inputs`). Each runs through the engine in a
 * separate process, from bytes to the first shape between the keys, with a time limit.
 */
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { messageOf } from '../../web/engine/api/errors.ts';
import { withEngine } from '../../web/engine/node.ts';
import { ownPeak } from './process-memory.ts';
import { SMALL_INPUTS } from './small-inputs.ts';
import type { SmallInput } from './small-inputs.ts';

/** Time and memory limits for every input. */
const MOST_MS = 2000,
  MOST_MB = 200;
/** A process is ended after this time. */
const GIVEN_UP_MS = 60_000;

/** An input of two triangles, to measure the process itself. */
const LITTLE: SmallInput = {
  name: 'two small triangles',
  files: ['a.obj', 'b.obj'].map((name, pose) => ({
    name,
    bytes: new TextEncoder().encode(`v 0 0 0\nv 1 0 0\nv 0 1 ${pose}\nf 1 2 3\n`),
  })),
};

interface InputRun {
  /** Processor time of all threads, independent of other programs. */
  ms: number;
  /** The largest resident set of the process. */
  mb: number;
  /** Short description of the outcome. */
  outcome: string;
}

async function run({ files }: SmallInput): Promise<InputRun> {
  const start = process.cpuUsage();
  const outcome = await withEngine(
    async (engine) => {
      const keys = await engine.importKeyframes(files);
      const sequence = await engine.createSequence(keys);
      const [first = 0, last = 0] = sequence.range;
      const [frame] = await sequence.evaluateMany([(first + last) / 2]);
      frame!.release();
      return `${keys.info.times.length} keys, ${keys.info.report.faces} faces`;
    },
    { threadsUrl: null },
  ).catch((error: unknown) => `refused: ${messageOf(error)}`);
  const { user, system } = process.cpuUsage(start);
  return { ms: (user + system) / 1000, mb: ownPeak(), outcome };
}

/** Runs an input in a separate process; 0 is the minimal input. */
function measured(index: number): InputRun {
  const { stdout, error } = spawnSync(process.execPath, [fileURLToPath(import.meta.url), 'inputs', String(index)], {
    encoding: 'utf8',
    timeout: GIVEN_UP_MS,
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  if (error || stdout === '') return { ms: Number.POSITIVE_INFINITY, mb: Number.NaN, outcome: 'ended after a minute' };
  return JSON.parse(stdout) as InputRun;
}

const shortened = (text: string): string => (text.length > 90 ? `${text.slice(0, 87)}...` : text);

/** All inputs as a table, or one by its number as a line of JSON. */
export async function benchInputs([number]: readonly string[], say: (text: string) => void): Promise<string> {
  if (number !== undefined) {
    const input = number === '0' ? LITTLE : SMALL_INPUTS[Number(number) - 1];
    if (!input) throw new Error(`There is no input ${number}.`);
    return JSON.stringify(await run(input));
  }
  const itself = measured(0);
  const missed: string[] = [];
  const rows = SMALL_INPUTS.map(({ name, files }, index) => {
    say(name);
    const { ms, mb, outcome } = measured(index + 1);
    const more = mb - itself.mb;
    const bytes = files.reduce((sum, file) => sum + file.bytes.length, 0);
    if (!(ms <= MOST_MS && (Number.isNaN(mb) || more <= MOST_MB))) missed.push(name);
    return `| ${index + 1} | ${name} | ${Math.round(bytes / 1000)} | ${Math.round(ms)} | ${Math.round(more)} | ${shortened(outcome)} |`;
  });
  const verdict =
    missed.length === 0
      ? `All ${rows.length} inputs stayed within ${MOST_MS / 1000} s and ${MOST_MB} MB.`
      : `Missed by ${missed.length} of ${rows.length}: ${missed.join('; ')}.`;
  return [
    verdict,
    '',
    `Times are processor times and include the start of the engine. Memory excludes the ${itself.mb.toFixed(0)} MB of the process itself.`,
    '',
    '| | input | kB | ms | MB | outcome |',
    '|---|---|---|---|---|---|',
    ...rows,
  ].join('\n');
}
