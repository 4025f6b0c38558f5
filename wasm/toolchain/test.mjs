// `npm test [-- all | SUITE [WORDS]]`: runs suites one after the other and reports their times.
import { mkdirSync } from 'node:fs';
import { nothing, reports, sentence, sum } from './counts.mjs';
import { Explained } from './log.mjs';
import { prepare, prepareSystem } from './prepare.mjs';
import { hasFiles, suites } from './suites.mjs';

const secondsSince = (moment) => (performance.now() - moment) / 1000;

// A suite that cannot be built has failed; the others still run.
async function runSuite(suite, words) {
  if (!hasFiles(...suite.files)) return nothing;
  const started = performance.now();
  let making;
  try {
    await prepare(suite.requirements, suite.steps);
    const made = await suite.compile?.(words);
    making = secondsSince(started);
    const counts = await suite.run(words, made);
    return { ...counts, making, running: secondsSince(started) - making };
  } catch (error) {
    if (!(error instanceof Explained)) throw error;
    process.stderr.write(`${error.message}\n`);
    making ??= secondsSince(started);
    const names = [error.message.split('\n', 1)[0]];
    return { ...nothing, failed: 1, names, making, running: secondsSince(started) - making };
  }
}

// Omits durations below half a second.
const duration = (seconds) => (seconds >= 0.5 ? `${seconds.toFixed(0)} s` : '');
const row = (name, counts, making, running) =>
  [name.padEnd(10), counts.padEnd(36), making.padStart(8), running.padStart(9)].join(' ').trimEnd();

function summarise(results, settingUp, total) {
  console.log(`\n${row('', '', 'making', 'running')}`);
  console.log(row('setting up', '', duration(settingUp), ''));
  for (const [name, counts] of Object.entries(results)) {
    const missing = counts.running === undefined;
    const running = counts.unchanged ? 'unchanged' : duration(counts.running);
    console.log(row(name, missing ? 'no files yet' : sentence(counts), duration(counts.making), running));
  }
  const all = sum(Object.values(results));
  for (const [name, { names = [] }] of Object.entries(results))
    for (const one of names) console.log(`failed in ${name}: ${one}`);
  console.log(`${sentence(all)}, in ${Math.floor(total / 60)} min ${(total % 60).toFixed(0)} s`);
  return all;
}

/** The suites to run, each with its words. */
export function chosen([which, ...words]) {
  if (which === undefined)
    return Object.entries(suites)
      .filter(([, suite]) => !suite.onlyInAll)
      .map(([name, suite]) => [name, suite.words ?? []]);
  if (which === 'all' && words.length === 0)
    return Object.entries(suites).map(([name, { wordsInAll = [] }]) => [name, wordsInAll]);
  if (Object.hasOwn(suites, which)) return [[which, words]];
  throw new Explained(`usage: npm test [-- all | SUITE [WORDS]]; the suites are ${Object.keys(suites).join(', ')}`);
}

export async function test(args) {
  const started = performance.now();
  const toRun = chosen(args);
  mkdirSync(reports, { recursive: true });
  await prepareSystem(toRun.flatMap(([name]) => suites[name].requirements));
  const settingUp = secondsSince(started);
  const results = {};
  for (const [name, words] of toRun) results[name] = await runSuite(suites[name], words);
  const total = summarise(results, settingUp, secondsSince(started));
  if (total.failed > 0 || total.passed === 0) process.exitCode = 1;
}
