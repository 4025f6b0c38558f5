// `npm run fuzz [-- [SECONDS] [TARGET]]`: runs each fuzz target for this many seconds, starting from the corpus and all
// earlier findings.
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { buildFuzzers, fuzzBundle } from './build.mjs';
import { run } from './exec.mjs';
import { whileLocked } from './lock.mjs';
import { Explained, step } from './log.mjs';
import { buildDir, inRoot, root } from './paths.mjs';
import { prepare, prepareSystem } from './prepare.mjs';
import { forFuzzing } from './requirements.mjs';

const DEFAULT_SECONDS = 60;
const ENDING = '_fuzz.cpp';
/** Third-party code called from JavaScript; its inputs are made in Node (tests/fuzz/decoders.ts). */
const DECODERS = ['meshopt', 'draco'];

export async function fuzz(args) {
  const known = readdirSync(inRoot('tests/fuzz'))
    .filter((name) => name.endsWith(ENDING))
    .map((name) => name.slice(0, -ENDING.length));
  const { seconds, importers } = fuzzArguments(args, [...known, ...DECODERS]);
  const found = [];
  const ours = importers.filter((importer) => known.includes(importer));
  if (ours.length > 0) {
    await prepareSystem(forFuzzing);
    const folder = await whileLocked(() => buildFuzzers(ours.map((importer) => `${importer}_fuzz`)));
    for (const importer of ours) found.push(...(await fuzzOne(folder, importer, seconds)));
  }
  const decoders = importers.filter((importer) => DECODERS.includes(importer));
  if (decoders.length > 0) await prepare([], [fuzzBundle]);
  for (const name of decoders) found.push(...(await fuzzDecoder(name, seconds)));
  if (found.length > 0) throw new Explained(found.join('\n'));
  step(`nothing was found in ${seconds} s ${importers.length > 1 ? 'each ' : ''}(${importers.join(', ')})`);
}

/** SECONDS is a positive integer, TARGET the name of an importer; both are optional. */
export function fuzzArguments(args, known) {
  const [first, ...others] = args;
  const timed = first !== undefined && /^\d+$/.test(first);
  const [only, ...rest] = timed ? others : args;
  const importer = only?.replace(/_fuzz$/, '');
  const seconds = timed ? Number(first) : DEFAULT_SECONDS;
  if (seconds < 1 || rest.length > 0 || (importer !== undefined && !known.includes(importer))) {
    throw new Explained(
      `usage: npm run fuzz [-- [SECONDS] [TARGET]], with a whole number of seconds from 1 for each target, and ${known.join(', ')} as targets`,
    );
  }
  return { seconds, importers: importer === undefined ? known : [importer] };
}

// A message about inputs that broke a promise; empty if there were none.
async function fuzzOne(folder, importer, seconds) {
  const grown = path.join(folder, 'corpus', importer);
  const artifacts = path.join(folder, 'found', importer);
  for (const made of [grown, artifacts]) mkdirSync(made, { recursive: true });
  const seeds = ['corpus', 'found'].map((kind) => inRoot('tests/fuzz', kind, importer)).filter(existsSync);
  const before = new Set(readdirSync(artifacts));
  step(`fuzzing the ${importer} importer for ${seconds} s`);
  const options = [
    `-max_total_time=${seconds}`,
    '-timeout=10',
    '-print_final_stats=1',
    `-artifact_prefix=${artifacts}/`,
  ];
  const { code } = await run(path.join(folder, `${importer}_fuzz`), [grown, ...seeds, ...options], {
    show: 'all',
    allowFailure: true,
  });
  if (code === 0) return [];
  const inputs = readdirSync(artifacts).filter((name) => !before.has(name) && !name.startsWith('slow-unit'));
  return inputs.length > 0
    ? inputs.map((name) => foundText(importer, path.join(artifacts, name)))
    : [`The ${importer} target ended with exit code ${code} without an input.`];
}

async function fuzzDecoder(name, seconds) {
  const artifacts = path.join(buildDir, 'fuzz-decoders', name);
  mkdirSync(artifacts, { recursive: true });
  const before = new Set(readdirSync(artifacts));
  step(`fuzzing the ${name} decoder for ${seconds} s`);
  const program = path.join(buildDir, 'node/fuzz-decoders.mjs');
  const { code } = await run(process.execPath, [program, name, String(seconds), artifacts], {
    show: 'all',
    allowFailure: true,
  });
  if (code === 0) return [];
  const inputs = readdirSync(artifacts).filter((file) => !before.has(file));
  return inputs.length > 0
    ? inputs.map((file) => foundText(name, path.join(artifacts, file)))
    : [`The ${name} target ended with exit code ${code} without an input.`];
}

/** Keeps the extension of the importer or decoder, which the replay uses. */
export function foundText(importer, artifact) {
  const ending = DECODERS.includes(importer) ? 'glb' : importer;
  const kept = `tests/fuzz/found/${importer}/WHAT-IS-THE-MATTER.${ending}`;
  const input = path.relative(root, artifact);
  return (
    `The ${importer} importer broke a promise, as said above, on ${input}. Keep it for the replay in npm test:\n` +
    `  mkdir -p ${path.dirname(kept)} && cp ${input} ${kept}`
  );
}
