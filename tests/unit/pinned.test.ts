/** Published actions are pinned by digest, because names and tags can change. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const lines = (name: string): string[] => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8').split('\n');

it('the actions of the workflow are commits', () => {
  const used = lines('.github/workflows/test.yml').filter((line) => line.includes('uses:'));
  expect(used.length).toBeGreaterThan(2);
  for (const line of used) expect(line).toMatch(/@[0-9a-f]{40} # v\d+\.\d+\.\d+$/);
});

it('what pip installs for Blender has digests', () => {
  const required = lines('wasm/toolchain/blender-requirements.txt').filter((line) => line && !line.startsWith('#'));
  expect(required.filter((line) => line.startsWith('bpy=='))).toHaveLength(1);
  for (const line of required) expect(line).toMatch(/^[\w-]+==[\w.]+ --hash=sha256:[0-9a-f]{64}$/);
});
