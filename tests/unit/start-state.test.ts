/** The initial state of opened files. */
import { expect, it } from 'vitest';
import { PosePool } from '../../web/app/session/pose-pool.ts';
import { ofFiles, restored } from '../../web/app/sources/start-state.ts';
import { KeyArrays } from '../../web/engine/caller/keyframes.ts';
import type { KeyData } from '../../web/engine/wire/protocol.ts';
import type { StoredProject } from '../../web/app/storage/project-shelf.ts';
import { docOfKeys, keyRef } from './documents.ts';

const animations = [
  { name: 'walk', start: 0, end: 2, keys: 49, moves: true },
  { name: 'nod', start: 0, end: 1, keys: 4, moves: true },
];
const hold = (keys: number, animation: number, project: object | null = null): string =>
  ofFiles(docOfKeys(...Array.from({ length: keys }, (_, i) => keyRef(i, `${i}`, i))), {
    animation,
    animations,
    project,
  }).motion.hold;

it('holding is on for poses sampled from an animation, but not for other poses, projects and two keys', () => {
  expect([hold(8, 0), hold(8, 1), hold(3, 0)]).toEqual(['on', 'on', 'on']);
  // A morph target animation whose keys are these poses, poses without an animation, a project, and two sampled times.
  expect([hold(4, 1), hold(8, -1), hold(8, 0, {}), hold(2, 0)]).toEqual(['off', 'off', 'off', 'off']);
});

it.each([
  ['of an earlier version, which knew no offset', undefined, [1001, 2, -497]],
  ['kept with another offset', [992, 0, -496], [9, 2, -1]],
  ['kept with the same offset', [1000, 0, -500], [1, 2, 3]],
] as const)('a pose that was added to far files stays where it was: %s', (_, offset, kept) => {
  const info = { names: ['a', 'b'], times: [0, 1], offset: [1000, 0, -500] };
  const files = { info, positions: [new Float32Array(3), new Float32Array(3)], normals: null };
  const pool = new PosePool(new KeyArrays(files as unknown as KeyData));
  const state = { doc: docOfKeys(keyRef(0, 'a', 0), keyRef(2, 'added', 1)) };
  const poses = [{ name: 'added', positions: Float32Array.from(kept) }];
  restored({ poses, ...(offset && { offset }), state } as unknown as StoredProject, pool);
  expect([...pool.keys.positions(2)]).toEqual([1, 2, 3]);
});
