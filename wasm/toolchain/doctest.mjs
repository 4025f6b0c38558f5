// Runs doctest cases on all cores: several processes, each with a range of the cases.
import { runReported, sum } from './counts.mjs';
import { run } from './exec.mjs';
import { Explained } from './log.mjs';
import { cores, inParallel } from './parallel.mjs';

// Enough ranges to make the last one short, and few enough to make start-up cheap.
const RANGES_PER_CORE = 3;

/** Splits 1 to `count` into at most this many non-empty ranges. */
function rangesOf(count, parts) {
  const ends = Array.from({ length: parts }, (_, i) => Math.round((count * (i + 1)) / parts));
  return ends.map((last, i) => ({ first: (ends[i - 1] ?? 0) + 1, last })).filter(({ first, last }) => first <= last);
}

const filters = (words) => words.map((word) => (word.startsWith('-') ? word : `--test-case=*${word}*`));

/** Runs `command`, a program with its first arguments. Words select cases by name or are doctest's own options. */
export async function runDoctest(name, [program, ...before], words) {
  // Cases of one file take similar time. A random order, equal for all processes, makes the ranges take similar time.
  const common = ['--no-version', '--no-colors', '--order-by=rand', '--rand-seed=1', ...filters(words)];
  const { tail } = await run(program, [...before, ...common, '--count']);
  const count = /current filters: (\d+)/.exec(tail)?.[1];
  if (count === undefined) throw new Explained(`${name}: the number of test cases is not in\n${tail}`);
  const ranges = rangesOf(Number(count), RANGES_PER_CORE * cores);
  const tasks = ranges.map(({ first, last }, i) => {
    const args = (report) => [
      ...before,
      ...common,
      '--minimal',
      `--first=${first}`,
      `--last=${last}`,
      `--report=${report}`,
    ];
    return () => runReported(`${name}-${i + 1}`, program, args, { show: 'after' });
  });
  const counts = sum(await inParallel(tasks));
  const ran = counts.passed + counts.failed + counts.skipped;
  if (counts.failed > 0 || ran === Number(count)) return counts;
  return { ...counts, failed: 1, names: [`${name}: ${ran} of ${count} cases ran`] };
}
