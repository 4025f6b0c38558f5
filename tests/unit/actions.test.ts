import { readdirSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Action } from '../../web/app/actions/action.ts';
import { bindActions } from '../../web/app/actions/action.ts';
import type { Context } from '../../web/app/actions/context.ts';
import { ACTIONS } from '../../web/app/actions/table.ts';

const actions = Object.values(ACTIONS) as Action[];

describe('the table of commands', () => {
  it('gives each key to one command', () => {
    const keys = actions.flatMap(({ keys: own = [] }) => own);
    expect(keys.filter((key, index) => keys.indexOf(key) !== index)).toEqual([]);
  });

  it('has a line in the help for each key', () => {
    const undescribed = actions.filter(({ keys = [], shown, does }) => keys.length > 0 && !(shown && does));
    expect(undescribed).toEqual([]);
  });

  it('keeps commands of different files apart', async () => {
    const folder = path.resolve(import.meta.dirname, '../../web/app/actions');
    const files = readdirSync(folder).filter((name) => !['action.ts', 'context.ts', 'table.ts'].includes(name));
    const modules = await Promise.all(files.map((name) => import(path.join(folder, name))));
    const tables = modules.map((module, index) => module[path.parse(files[index]!).name.toUpperCase()] as object);
    const ids = tables.flatMap((table) => Object.keys(table));
    expect(ids).toHaveLength(Object.keys(ACTIONS).length);
  });
});

describe('bound commands', () => {
  const errors: unknown[] = [];
  const context = { feedback: { onError: (error: unknown) => errors.push(error) } } as unknown as Context;
  const bound = bindActions(
    {
      add: { run: (_: Context, a: number, b: number) => a + b },
      fail: { run: (_: Context) => Promise.reject(new Error('no')) },
    },
    context,
  );

  it('return the result of the command', () => {
    expect(bound.add(1, 2)).toBe(3);
  });

  it('report failures', async () => {
    await bound.fail();
    expect(errors.map(String)).toEqual(['Error: no']);
  });
});
