/**
 * Wasm and native code agree: both are compared with the shapes in native-shapes.json, native code by
 * native/agreement_test.cpp.
 */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { frameAt, testEngine } from './support/engines.ts';
import { diagonal, largestDistance } from './support/shapes.ts';

const engine = testEngine();
const shared = JSON.parse(readFileSync(new URL('../native-shapes.json', import.meta.url), 'utf8')) as {
  faces: number[];
  keys: number[][];
  times: number[];
  every: number;
  shapes: number[][];
};

/** The numbers as written in the file, because the engine itself rounds them to float. */
function objOf(positions: number[]): Uint8Array {
  const triples = (numbers: number[]): number[][] =>
    Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
  const lines = [
    ...triples(positions).map((xyz) => `v ${xyz.join(' ')}`),
    ...triples(shared.faces).map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`),
  ];
  return new TextEncoder().encode(lines.join('\n'));
}

it('wasm agrees with native double to 1e-6 of the diagonal', async () => {
  const files = shared.keys.map((key, i) => ({ name: `key-${i}.obj`, bytes: objOf(key) }));
  const keys = await engine.importKeyframes(files);
  const sequence = await engine.createSequence(keys, { precision: 'exact' });
  for (const [k, t] of shared.times.entries()) {
    const { positions } = await frameAt(sequence, t);
    const some = positions.filter((_, i) => Math.floor(i / 3) % shared.every === 0);
    expect(largestDistance(some, shared.shapes[k]!)).toBeLessThan(1e-6 * diagonal(Float32Array.from(shared.keys[0]!)));
  }
});
