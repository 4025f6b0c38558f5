/** The fewest keys of an animation that reproduce it within an error, measured at times between the samples. */
import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { fewestKeys } from '../../web/study/fewest-keys.ts';
import { readReference } from '../../web/study/reference-motion.ts';
import { dataFile, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';
import { rigFile } from './support/rig.ts';

const engine = testEngine();

interface Input {
  what: string;
  read(): Promise<InputFile> | InputFile;
  there: boolean;
  /** Ratio of the error between the samples to the tolerance. The rig has steps that sampling misses. */
  slack: number;
}

const inputs: Input[] = [
  { what: 'a generated rig', read: rigFile, there: true, slack: 2 },
  { what: 'CesiumMan @all', read: () => dataFile('skin/CesiumMan.glb'), there: hasData, slack: 1.05 },
  { what: 'Fox @all', read: () => dataFile('skin/Fox.glb'), there: hasData, slack: 1.05 },
];

/** Largest distance between the motion through these keys and the animation, relative to the diagonal. */
async function errorAt(file: InputFile, keyTimes: number[], times: number[]): Promise<number> {
  const keys = await engine.importKeyframes([file], { sample: keyTimes });
  const reference = await engine.importKeyframes([file], { sample: times });
  const sequence = await engine.createSequence(keys);
  const frames = await sequence.evaluateMany(times);
  let largest = 0;
  frames.forEach(({ positions }, index) => {
    const wanted = reference.positions(index);
    for (let i = 0; i < wanted.length; i += 3)
      largest = Math.max(largest, Math.hypot(...[0, 1, 2].map((c) => positions[i + c]! - wanted[i + c]!)));
  });
  const { diagonal } = keys.info.report;
  for (const made of [sequence, keys, reference]) made.dispose();
  return largest / diagonal;
}

describe('the fewest keys of an animation', () => {
  for (const { what, read, there, slack } of inputs) {
    it.skipIf(!there)(`are found for ${what}`, { timeout: 120_000 }, async () => {
      const file = await read();
      const { info } = await engine.importKeyframes([file]);
      const animation = info.animations[0]!;
      const reference = await readReference(engine, [file], 0, animation, info.report.vertices, {});
      const { start, end } = animation;
      const between = Array.from({ length: 61 }, (_, i) => start + ((end - start) * (i + 0.37)) / 62);
      const counts: number[] = [];
      for (const tolerance of [0.04, 0.02]) {
        const stages: number[] = [];
        const found = await fewestKeys(engine, reference, {
          tolerance,
          max: 64,
          options: {},
          onProgress: ({ fraction }) => stages.push(fraction),
        });
        const error = await errorAt(file, found.times, between);
        expect(found.error).toBeLessThanOrEqual(tolerance);
        expect(error).toBeLessThan(slack * tolerance);
        expect(found.times[0]).toBe(start);
        expect(found.times.at(-1)).toBe(end);
        expect(stages.at(-1)).toBe(1);
        counts.push(found.times.length);
      }
      expect(counts[0]).toBeLessThan(counts[1]!);
      expect(counts[1]).toBeLessThan(reference.times.length / 2);
      const limited = await fewestKeys(engine, reference, { tolerance: 1e-6, max: 5, options: {} });
      expect(limited.times).toHaveLength(5);
      expect(limited.error).toBeGreaterThan(1e-6);
      reference.dispose();
    });
  }
});
