/** Comments and running text stay within 120 columns; the formatters break only code. */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../..');
const COLUMNS = 120;

const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
  cwd: root,
  encoding: 'utf8',
})
  .split('\n')
  .filter((file) => /(\.(ts|mjs|js|h|cpp|md)|CMakeLists\.txt)$/.test(file) && !file.includes('bench/results/'))
  .filter((file) => existsSync(path.join(root, file)));

/** Lines that need breaking by hand; table rows and bibliography entries cannot be broken. */
function isText(line: string, file: string): boolean {
  if (file.endsWith('.md')) return !/^\|/.test(line) && !/^ +\w+ += \{/.test(line);
  return file.endsWith('CMakeLists.txt') || /^\s*(\/\/|\/\*|\*)/.test(line) || /[;,{})] \/\/ /.test(line);
}

it(`no comment and no line of a README is longer than ${COLUMNS} columns`, () => {
  expect(files.length).toBeGreaterThan(300);
  const long = files.flatMap((file) =>
    readFileSync(path.join(root, file), 'utf8')
      .split('\n')
      .flatMap((line, index) => (line.length > COLUMNS && isText(line, file) ? [`${file}:${index + 1}`] : [])),
  );
  expect(long).toEqual([]);
});
