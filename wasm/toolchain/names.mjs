// The lint of names: private words that identifiers and file names must not contain, because the field has a term.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { root } from './paths.mjs';
import { codeOf } from './words.mjs';

/** Patterns of an identifier's words, in lower case, each with the term to use. */
export const PRIVATE = [
  ['(most|least) [a-z]+', 'max, min'],
  ['truths?', 'reference'],
  ['true shapes', 'reference shapes'],
  ['doubts?', 'warning'],
  ['lying|lies', 'up axis, orientation'],
  ['untold|foretold', 'not reported, predicted'],
  ['patient', 'fallback'],
  ['deck', 'timeline area'],
  ['create (import )?sheet', 'import dialog'],
  ['with sheet', 'capture canvas'],
  ['gltf look|create look', 'materials, display options'],
  ['at moment', 'at time'],
  ['key place', 'insert position'],
  ['(pin|film|analysis) places?', 'position, container'],
  ['when there', 'wait for'],
  ['order beside', 'parallel ordering'],
  ['beside core|url beside', 'sibling'],
  ['meant times|is meant', 'timestamps, is importable'],
  ['(sample|ramp) way', 'mode, direction'],
  ['mean way', 'mean offset'],
  ['(create|io) ways', 'controllers'],
  ['part way', 'at a fraction'],
  ['gives way', 'is covered'],
  ['(core|file|shell) answers', 'handlers'],
  ['questions', 'queries'],
  ['(served document|on served)', 'applied'],
  ['create visit', 'startup'],
  ['create real', 'app connection'],
  ['there and back|to and fro', 'ping pong, round trip'],
  ['why no (lengths|paths)', 'conflict'],
  ['ruled out', 'conflict'],
  ['wrong with', 'validation error'],
  ['strange link', 'unknown link'],
  ['briefly', 'what makes it short: thinned, rounded'],
  ['what is said', 'evidence'],
  ['standing of', 'up axis guess'],
  ['(led|lead) shape', 'deformation transfer'],
  ['left out sentence', 'ignored values'],
  ['kept (doc|document)', 'stored document'],
  ['held time', 'frame start time'],
  ['can be held', 'fits in memory'],
  ['holds? (files|lock|object)', 'has, acquire'],
  ['rests (little|whole)', 'fade start, fade end'],
  ['(goes|turns?) far', 'large rotation, fade end'],
  ['turns little', 'fade start'],
  ['blend with body', 'blend with group'],
  ['time peek', 'hover preview'],
  ['one stop', 'roving tabindex'],
  ['given files', 'source files'],
  ['somebody|nobody|whoever|whomever|who|whom', 'name the actor: user, page, caller, reader'],
  ['besides|likewise|anew', 'other, same, again'],
  ['stuff|whatever|somewhat|anyway', 'name the thing'],
].map(([words, instead]) => ({ pattern: new RegExp(`(?<![a-z0-9])(?:${words})(?![a-z0-9])`), instead }));

/** `readTruth_`, `READ_TRUTH` and `read-truth` are all “read truth”. */
export const wordsOf = (name) =>
  name
    .replace(/([a-z0-9])(?=[A-Z])|([A-Z])(?=[A-Z][a-z])/g, '$1$2 ')
    .replace(/[^A-Za-z0-9]+/g, ' ')
    .toLowerCase()
    .trim();

const privateWords = (name) => PRIVATE.find(({ pattern }) => pattern.test(wordsOf(name)));

/** The private names in a file's path and code, as { line, name, instead }. Line 0: the path. */
export function privateNamesIn(file, source) {
  const found = [];
  const note = (line, name) => {
    const is = privateWords(name);
    if (is) found.push({ line, name, instead: is.instead });
  };
  for (const part of file.split('/')) note(0, part);
  const code = codeOf(file, source) ?? '';
  code.split('\n').forEach((text, index) => {
    for (const name of new Set(text.match(/[A-Za-z_$][\w$]*/g))) note(index + 1, name);
  });
  return found;
}

/** Inputs of the fuzz tests are named after their defects. */
const RECORDS = /fuzz\/(corpus|found)\//;

/** All private names in files listed by Git, one sentence each. */
export function lintNames() {
  return execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
    cwd: root,
    encoding: 'utf8',
  })
    .split('\n')
    .filter((file) => file && !RECORDS.test(file) && existsSync(path.join(root, file)))
    .flatMap((file) => {
      const source = /\.(ts|tsx|mts|mjs|js|h|cpp)$/.test(file) ? readFileSync(path.join(root, file), 'utf8') : '';
      return privateNamesIn(file, source).map(
        ({ line, name, instead }) => `${file}${line > 0 ? `:${line}` : ''}: the name “${name}”; instead: ${instead}`,
      );
    });
}
