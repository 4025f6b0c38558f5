import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { expect, it } from 'vitest';
import { withoutUnusedShaders } from '../../web/viewer/unused-shaders.ts';

const three = path.join(path.dirname(createRequire(import.meta.url).resolve('three')), 'three.module.js');

it('only shader parts are removed from three, by name', () => {
  const code = readFileSync(three, 'utf8');
  const left = withoutUnusedShaders(code);
  expect(code.length - left.length).toBeGreaterThan(30_000);
  expect(left.split('\n').length).toBe(code.split('\n').length);
  expect(left).toContain('var transmission_pars_fragment = "";');
  expect(left).toMatch(/^var lights_physical_pars_fragment = ".{1000}/m);
});

it('a part missing in a newer three is reported', () => {
  expect(() => withoutUnusedShaders('var fog_vertex = "void";')).toThrow(/no shader part/);
});
