// Reads a suite's report: numbers of passed, failed and skipped tests, and names of failed ones.
import { existsSync, readFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { run } from './exec.mjs';
import { buildDir } from './paths.mjs';

export const reports = path.join(buildDir, 'reports');
export const nothing = { passed: 0, failed: 0, skipped: 0, names: [] };

export const sum = (list) =>
  list.reduce(
    (total, { passed, failed, skipped, names = [] }) => ({
      passed: total.passed + passed,
      failed: total.failed + failed,
      skipped: total.skipped + skipped,
      names: [...total.names, ...names],
    }),
    nothing,
  );

export const sentence = ({ passed, failed, skipped }) => `${passed} passed, ${failed} failed, ${skipped} skipped`;

/**
 * Runs a program that writes a JSON report. A program that writes none, or fails without a failed test, counts as a
 * failure.
 */
export async function runReported(name, program, args, { count = (counts) => counts, env = {}, show = 'all' } = {}) {
  const report = path.join(reports, `${name}.json`);
  rmSync(report, { force: true });
  const { code } = await run(program, args(report), { show, allowFailure: true, env });
  if (!existsSync(report)) return { ...nothing, failed: 1, names: [`${name} wrote no report`] };
  const counts = count(JSON.parse(readFileSync(report, 'utf8')));
  if (code === 0 || counts.failed > 0) return counts;
  return { ...counts, failed: 1, names: [`${name} ended with code ${code}`] };
}
