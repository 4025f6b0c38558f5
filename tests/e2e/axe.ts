/** Serious axe findings on a page, or in parts of it. */
import { AxeBuilder } from '@axe-core/playwright';
import { expect } from './support.ts';
import type { App } from './support.ts';

interface Looked {
  rules?: string[];
  /** Selectors; default: the whole page. */
  parts?: string[];
}

export async function expectAccessible(app: App, { rules, parts = [] }: Looked = {}): Promise<void> {
  let builder = new AxeBuilder({ page: app.page });
  if (rules) builder = builder.withRules(rules);
  for (const part of parts) builder = builder.include(part);
  const { violations } = await builder.analyze();
  const grave = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  expect(grave.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => String(target)).join(' | ')}`)).toEqual([]);
}
