// The lint of words: patterns that make sentences hard to understand. CONTRIBUTING.md has the rules.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { root } from './paths.mjs';

/** Each pattern with the advice that the lint prints. A space in a pattern also matches a line break. */
const BANNED = [
  ['somebody|nobody|whoever|whomever', 'name the actor: user, page, caller, reader'],
  ['(tell|tells|telling|told) of', 'report, describe'],
  ['(is|are|be|been|was|were|being) told', 'is notified, receives; “told apart” is “distinguished”'],
  ['hear|hears|heard', 'receives, is notified'],
  ['besides', 'also, in addition to'],
  ['likewise', 'name what is meant, or “the same for”'],
  ['so (many|much)', 'give the number or the name of the parameter'],
  ['anew', 'again'],
  ['no more(?! than| [a-z]+s )', 'no longer, stop'],
  ['any more', 'no longer'],
  ['another one', 'another and the noun, a different one'],
  ['(?<=,\\s+)so that', 'start a sentence, or “so”'],
  ['factoris(e|es|ed|ing)', 'factor'],
  ['foretold', 'predicted'],
  ['blanks', 'spaces'],
  ['there and back', 'forwards and backwards; “round trip” for files'],
  ['turned round', 'with opposite sign'],
  ['that is to be', 'use the verb'],
  ['(for|of) who', 'name the actor'],
  ['of it (is|are|was|were|may|can|has|stays|goes)', 'name the subject'],
  ['turn(s|ed|ing)?( so| that| as| very| too)? far', 'rotate by a large angle, large rotation'],
  ['(come|comes|came|coming) near(er|est)? to', 'is closest to'],
  ['(nothing|infinite|false|true),?( too,)? where', 'returns nullopt, false or true if'],
].map(([words, instead]) => ({
  pattern: new RegExp(`(?<![\\w-])(?:${words.replaceAll(' ', '\\s+')})(?![\\w-])`, 'gi'),
  instead,
}));

/** At most 20 uses of banned words, each with its reason. */
export const EXCEPTIONS = [
  { file: 'wasm/toolchain/words.mjs', words: /./, why: 'names the banned words' },
  { file: 'wasm/toolchain/names.mjs', words: /there and back/, why: 'names a banned name' },
  { file: 'tests/unit/words.test.ts', words: /./, why: 'tests the banned words' },
  { file: 'wasm/core/sparse/README.md', words: /factorise/, why: 'names a function of the solver' },
];

const RECORDS = /fuzz\/corpus\/|^public\/samples\/(?!samples\.json$)|^LICENSE$/;
const CODE = /\.(ts|tsx|mts|mjs|js|h|cpp|css)$/;
const SCRIPT = /\.(py|ya?ml|cmake)$|CMakeLists\.txt$|^\.ci\//;
const DOCUMENT = /\.(md|html|cff)$/;
/** JSON with texts for users. Other JSON is configuration or data. */
const DATA = /^(public\/.*\.(json|webmanifest)|package\.json)$/;

const TOKEN = new RegExp(
  [
    String.raw`(?://[^\n]*\n[ \t]*)*//[^\n]*`,
    String.raw`/\*[^]*?\*/`,
    String.raw`"(?:[^"\\\n]|\\.)*"`,
    String.raw`'(?:[^'\\\n]|\\.)*'`,
    String.raw`\`(?:[^\`\\]|\\[^])*\``,
  ].join('|'),
  'g',
);

/**
 * Replaces code by a character that is neither a letter nor a space, so no phrase spans code and offsets stay the same.
 */
const hide = (code) => code.replace(/[^\n]/g, '¦');

function keepOnly(source, tokens, kept = (token) => token) {
  let result = '';
  let end = 0;
  for (const { 0: token, index } of source.matchAll(tokens)) {
    result += hide(source.slice(end, index)) + kept(token);
    end = index + token.length;
  }
  return result + hide(source.slice(end));
}

/** Comments without the marks at the start of their lines, and strings of several words. */
function textOfToken(token) {
  if (token.startsWith('/')) return token.replace(/\n[ \t]*(\/\/|\*(?!\/))/g, (mark) => mark.replace(/[/*]/g, ' '));
  return token.includes(' ') ? token.replace(/\$\{[^}]*\}/g, hide) : hide(token);
}

/** The readable text of a file, with everything else hidden; null for other files. */
export function textOf(file, source) {
  if (CODE.test(file)) return keepOnly(source, TOKEN, textOfToken);
  if (DATA.test(file)) return keepOnly(source, /"(?:[^"\\\n]|\\.)*"/g, textOfToken);
  if (SCRIPT.test(file)) return keepOnly(source, /(?<=^|\s)#.*/g);
  if (!DOCUMENT.test(file)) return null;
  return source
    .replace(/`[^`\n]+`|\]\([^)\s]*\)|<\/?\w+/g, hide)
    .replace(/\b(class|id|for|href|src|data-\w+)="[^"]*"/g, hide);
}

/** The code of a file, with comments, strings and the text of templates hidden; null for other files. */
export function codeOf(file, source) {
  if (!CODE.test(file) || file.endsWith('.css')) return null;
  return source.replace(TOKEN, (token) => (token.startsWith('`') ? keepOnly(token, /(?<=\$\{)[^}]*/g) : hide(token)));
}

/** The banned words in a file's text, as { line, words, instead }. */
export function bannedIn(file, source) {
  const text = textOf(file, source);
  if (text === null) return [];
  return BANNED.flatMap(({ pattern, instead }) =>
    Array.from(text.matchAll(pattern), ({ 0: words, index }) => ({
      line: text.slice(0, index).split('\n').length,
      words: words.replace(/\s+/g, ' '),
      instead,
    })),
  );
}

const isException = (file, words) => EXCEPTIONS.some((one) => one.file === file && one.words.test(words));

/** Files with readable text, as listed by Git. */
export const readableFiles = () =>
  execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], { cwd: root, encoding: 'utf8' })
    .split('\n')
    .filter((file) => [CODE, SCRIPT, DOCUMENT, DATA].some((kind) => kind.test(file)) && !RECORDS.test(file))
    .filter((file) => existsSync(path.join(root, file)));

/** All banned words in the covered files, one sentence each. */
export function lintWords(files = readableFiles()) {
  return files.flatMap((file) =>
    bannedIn(file, readFileSync(path.join(root, file), 'utf8'))
      .filter(({ words }) => !isException(file, words))
      .map(({ line, words, instead }) => `${file}:${line}: “${words}”; instead: ${instead}`),
  );
}
