/** Conversions of full turns between the document, the engine and a saved project. */
import { expect, it } from 'vitest';
import { documentFromImport } from '../../web/app/session/document-from-import.ts';
import { sequencePlan } from '../../web/app/session/sequence-plan.ts';
import type { PosePool } from '../../web/app/session/pose-pool.ts';
import type { AddedTurns, KeysInfo } from '../../web/engine/api/types.ts';
import { setTurns } from '../../web/model/edits.ts';
import type { Doc } from '../../web/model/state.ts';

const pool = {} as PosePool;
const opened = (turns?: AddedTurns[]): Doc =>
  documentFromImport(
    { names: ['a', 'b', 'c'], times: [0, 0.5, 1], project: turns ? { turns } : null } as unknown as KeysInfo,
    pool,
  );
const turnsIn = (doc: Doc): object[] => doc.keys.map(({ shaping }) => shaping.turns);
const whole: AddedTurns = { key: 1, turns: -2 };
const parts: AddedTurns[] = [
  { key: 1, turns: 1, component: 3 },
  { key: 2, turns: 2, component: 0 },
];

it('a project restores the turns of the whole shape and its parts', () => {
  const doc = opened([whole, ...parts]);
  expect(turnsIn(doc)).toEqual([[], [{ turns: -2 }, { component: 3, turns: 1 }], [{ component: 0, turns: 2 }]]);
  expect(sequencePlan(doc).motion.turns).toEqual([whole, ...parts]);
});

it('the first key has no turns', () => {
  expect(sequencePlan(setTurns(opened(), 0, { component: 1, turns: 1 })).motion.turns).toEqual([]);
});
