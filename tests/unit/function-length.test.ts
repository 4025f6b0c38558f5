/** No function of the front end is so long that it cannot be seen at once; functions within it count in it. */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import ts from 'typescript';
import { expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../..');
const LINES = 80;

/** Still too long. A file that has become shorter leaves the list. */
const ALLOWED = [
  'web/app/app.ts',
  'web/app/kept/remembered-files.ts',
  'web/app/panels/commands.ts',
  'web/app/panels/components.ts',
  'web/app/panels/layout.ts',
  'web/app/panels/page.ts',
  'web/app/sources/animation.ts',
  'web/app/sources/open-files.ts',
  'web/app/sources/take-files.ts',
  'web/app/ways.ts',
  'web/ui/clock-menu.ts',
  'web/ui/export-dialog.ts',
  'web/ui/gallery.ts',
  'web/ui/ghost-panel.ts',
  'web/ui/header.ts',
  'web/ui/key-editor.ts',
  'web/ui/key-strip.ts',
  'web/ui/motion-panel.ts',
  'web/ui/sampling.ts',
  'web/ui/shape-panel.ts',
  'web/ui/speed-handles.ts',
  'web/ui/timeline.ts',
  'web/ui/transport.ts',
  'web/ui/view-bar.ts',
];

const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard', 'web'], {
  cwd: root,
  encoding: 'utf8',
})
  .split('\n')
  .filter((file) => /\.(ts|mjs|js)$/.test(file) && existsSync(path.join(root, file)));

/** Those of a file that are too long, with their names and lines. */
function longFunctions(file: string): string[] {
  const source = ts.createSourceFile(file, readFileSync(path.join(root, file), 'utf8'), ts.ScriptTarget.Latest, true);
  const lineAt = (place: number): number => source.getLineAndCharacterOfPosition(place).line;
  const found: string[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isFunctionLike(node)) {
      const lines = lineAt(node.end) - lineAt(node.getStart(source)) + 1;
      const { name } = ts.isVariableDeclaration(node.parent) ? node.parent : node;
      if (lines > LINES) found.push(`${file}: ${name?.getText(source) ?? 'a function'}, ${lines} lines`);
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}

it(`no function of the front end has more than ${LINES} lines`, { timeout: 30_000 }, () => {
  expect(files.length).toBeGreaterThan(300);
  const long = files.flatMap(longFunctions);
  expect(long.filter((one) => !ALLOWED.some((file) => one.startsWith(`${file}:`)))).toEqual([]);
  expect(ALLOWED.filter((file) => !long.some((one) => one.startsWith(`${file}:`)))).toEqual([]);
});
