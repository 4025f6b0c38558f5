/** What axe finds grave on a page. */
import { AxeBuilder } from '@axe-core/playwright';
import { expect } from './support.ts';
import type { App } from './support.ts';

export async function expectAccessible(app: App, rules?: string[]): Promise<void> {
  const builder = new AxeBuilder({ page: app.page });
  const { violations } = await (rules ? builder.withRules(rules) : builder).analyze();
  const grave = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  expect(grave.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => String(target)).join(' | ')}`)).toEqual([]);
}
