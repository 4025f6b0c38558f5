import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import ts from 'typescript';
import { expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../..');
const MOST_LINES = 80;

it('no function in web has more lines than fit on a screen', () => {
  const listed = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard', 'web'], { cwd: root });
  const files = listed
    .toString()
    .split('\n')
    .filter((file) => file.endsWith('.ts') && existsSync(path.join(root, file)));
  expect(files.length).toBeGreaterThan(0);
  expect(files.flatMap((file) => longFunctions(path.join(root, file)))).toEqual([]);
});

function longFunctions(file: string): string[] {
  const source = ts.createSourceFile(file, readFileSync(file, 'utf8'), ts.ScriptTarget.Latest, true);
  const found: string[] = [];
  const lineOf = (at: number): number => source.getLineAndCharacterOfPosition(at).line + 1;
  const visit = (node: ts.Node): void => {
    if (ts.isFunctionLike(node) && 'body' in node && node.body) {
      const [first, last] = [lineOf(node.getStart()), lineOf(node.end)];
      if (last - first + 1 > MOST_LINES) found.push(`${path.basename(file)}:${first} has ${last - first + 1} lines`);
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}
