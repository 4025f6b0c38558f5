/** Key names of the page in its exports. */
import { expect, it } from 'vitest';
import { documentFromImport } from '../../web/app/session/document-from-import.ts';
import { PosePool } from '../../web/app/session/pose-pool.ts';
import { sequencePlan } from '../../web/app/session/sequence-plan.ts';
import { SequenceSet } from '../../web/app/session/sequence-set.ts';
import { withEngine } from '../../web/engine/node.ts';
import { renameKey, retimeKey, setMotion } from '../../web/model/edits.ts';
import { DEFAULT_VIEW } from '../../web/model/state.ts';

const obj = (z: number): string => `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 ${z}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n`;
const pose = (name: string, z: number) => ({ name, bytes: new TextEncoder().encode(obj(z)) });

interface Exported {
  meshes: { extras: { targetNames: string[] } }[];
}

/** Names of the exported targets, without times. */
function targetsOf(glb: Uint8Array): string[] {
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const { meshes } = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length))) as Exported;
  return meshes[0]!.extras.targetNames.map((name) => name.replace(/ t=.*/, '')).filter((name) => !/^t=/.test(name));
}

it.each(['lri', 'lengths'] as const)(
  'renamed and moved keys have their new names in an export of %s',
  async (method) => {
    await withEngine(async (engine) => {
      const keys = await engine.importKeyframes([pose('a.obj', 1), pose('b.obj', 1.2), pose('c.obj', 1.1)]);
      const pool = new PosePool(keys);
      const onRefused = (error: unknown): never => {
        throw error;
      };
      const set = new SequenceSet(engine, pool, { onProgress: () => undefined, onReady: () => undefined, onRefused });
      const doc = setMotion(renameKey(documentFromImport(keys.info, pool), 2, ''), { method });
      const view = { ...DEFAULT_VIEW, compare: ['linear' as const] };
      for (const next of [doc, retimeKey(renameKey(doc, 1, 'SMILE'), 2, 3)]) {
        set.want(sequencePlan(next, view));
        await set.idle();
      }
      expect(set.all.length).toBe(2);
      for (const { sequence } of set.all) {
        const [glb] = await sequence.export({ format: 'glb' });
        expect(targetsOf(glb!.bytes)).toEqual(expect.arrayContaining(['SMILE', '3 s']));
        expect(targetsOf(glb!.bytes)).not.toContain('b');
      }
      set.dispose();
    });
  },
);
