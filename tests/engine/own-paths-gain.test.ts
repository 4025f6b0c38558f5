/** Effect of own paths on the error against a real animation, alone, with holding and with a pin. */
import { expect, it } from 'vitest';
import { ownPathsGain } from '../../web/app/analysis/own-paths-gain.ts';
import { readReference } from '../../web/study/reference-motion.ts';
import { dataFile, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

it.skipIf(!hasData)(
  'own paths bring a running soldier closer to its animation, and holding takes most of it',
  async () => {
    const file = dataFile('skin/Soldier.glb');
    const { animations } = (await engine.importKeyframes([file])).info;
    const animation = animations.findIndex(({ name }) => name === 'Run');
    const keys = await engine.importKeyframes([file], { animation, sample: 5 });
    const { report, offset } = keys.info;
    const reference = await readReference(engine, [file], animation, animations[animation]!, report.vertices, {
      offset,
    });
    const shape = await engine.encode(keys);
    const signal = new AbortController().signal;
    const gain = async (options: object): Promise<number> => {
      const { off, own } = await ownPathsGain({ motion: await shape.motion(options), reference, ms: 1, signal });
      return 1 - own / off;
    };
    expect(await gain({})).toBeGreaterThan(0.02);
    expect(await gain({ pins: [{ vertex: 0, radius: 0.05 }] })).toBeGreaterThan(0.02);
    const held = await gain({ hold: 'on' });
    expect(held).toBeGreaterThan(0);
    expect(held).toBeLessThan(0.02);
  },
);
