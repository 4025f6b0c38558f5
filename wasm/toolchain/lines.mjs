// Counts lines of code of the product and the tests by language, without blank lines and comments.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { root } from './paths.mjs';

// Start and end of comments; '' ends with the line.
const SLASHES = [
  ['/*', '*/'],
  ['//', ''],
];
const COMMENTS = {
  'C++': SLASHES,
  TypeScript: SLASHES,
  CSS: [['/*', '*/']],
  HTML: [['<!--', '-->']],
  CMake: [['#', '']],
  Python: [['#', '']],
};
const LANGUAGE = {
  '.cpp': 'C++',
  '.h': 'C++',
  '.ts': 'TypeScript',
  '.tsx': 'TypeScript',
  '.mjs': 'TypeScript',
  '.mts': 'TypeScript',
  '.js': 'TypeScript',
  '.css': 'CSS',
  '.html': 'HTML',
  '.py': 'Python',
};
const QUOTES = ['"', "'", '`'];

/** The language of a file by its name, or undefined. */
export const languageOf = (file) => (path.basename(file) === 'CMakeLists.txt' ? 'CMake' : LANGUAGE[path.extname(file)]);

/** Counts lines except blank ones and pure comments. */
export function codeLines(text, language) {
  let count = 0;
  let until = ''; // end mark of a comment or template that continues from the previous line
  let inText = false;
  for (const line of text.split('\n')) {
    let isCode = false;
    for (let at = 0; at < line.length; at += 1) {
      if (until) {
        isCode ||= inText && line[at].trim() !== '';
        if (inText && line[at] === '\\') at += 1;
        else if (line.startsWith(until, at)) {
          at += until.length - 1;
          until = '';
        }
        continue;
      }
      const comment = COMMENTS[language].find(([start]) => line.startsWith(start, at));
      inText = !comment && language !== 'HTML' && QUOTES.includes(line[at]);
      if (comment?.[1] === '') break;
      if (comment) at += comment[0].length - 1;
      until = comment?.[1] ?? (inText ? line[at] : '');
      isCode ||= !comment && line[at].trim() !== '';
    }
    // Only comments and templates continue on the next line.
    if (inText && until !== '`') until = '';
    if (isCode) count += 1;
  }
  return count;
}

/** Counts all files that git tracks, for `npm run lines`. */
export function printLines() {
  const files = execFileSync('git', ['ls-files', '-z'], { cwd: root, encoding: 'utf8' }).split('\0').filter(languageOf);
  const sums = {};
  for (const file of files) {
    const part = file.startsWith('tests/') ? 'tests' : 'product';
    sums[languageOf(file)] ??= { product: 0, tests: 0 };
    sums[languageOf(file)][part] += codeLines(readFileSync(path.join(root, file), 'utf8'), languageOf(file));
  }
  const total = { product: 0, tests: 0 };
  for (const row of Object.values(sums)) for (const part of Object.keys(total)) total[part] += row[part];
  for (const [name, { product, tests }] of [...Object.entries(sums), ['all', total]])
    process.stdout.write(
      `${name.padEnd(12)}${String(product).padStart(8)} product${String(tests).padStart(8)} tests\n`,
    );
}
