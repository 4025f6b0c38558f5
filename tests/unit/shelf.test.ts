/** Storage of a browser between visits: only complete records are opened. */
import { expect, it } from 'vitest';
import { areFiles, readRecord } from '../../web/app/storage/project-shelf.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const state = {
  ...EMPTY_STATE,
  source: { kind: 'files', names: ['a.glb'] },
  doc: docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1)),
};
const poses = [{ name: 'mine', positions: new Float32Array(9) }];
const whole = { format: 3, id: 'x', version: 1, opening: false, changed: 7, options: {}, poses, state };

it('a whole record reads', () => {
  expect(readRecord(whole)).toEqual({ id: 'x', names: ['a.glb'], changed: 7, opening: false });
  expect(areFiles([{ name: 'a.glb', bytes: new Uint8Array(3) }])).toBe(true);
});

it.each([
  undefined,
  'nonsense',
  { ...whole, format: 99 },
  { ...whole, id: 5 },
  { ...whole, poses: [{ name: 'mine' }] },
  { ...whole, poses: [null] },
  { ...whole, options: 'nonsense' },
  { ...whole, state: {} },
  { ...whole, state: { ...state, source: { kind: 'sample', id: 'cactus' } } },
  { ...whole, state: { ...state, source: { kind: 'files' } } },
  { ...whole, state: { ...state, source: { kind: 'files', names: [1] } } },
  { ...whole, state: { ...state, doc: { ...state.doc, keys: [null] } } },
  { ...whole, state: { ...state, doc: { ...state.doc, keys: [{ pose: 0.5, name: 'a', time: 0 }] } } },
  { ...whole, state: { ...state, doc: { ...state.doc, keys: [{ pose: 0, name: 'a', time: NaN }] } } },
  { ...whole, state: { ...state, view: 1 } },
])('a damaged one does not: %#', (record) => {
  expect(readRecord(record)).toBeNull();
});

it.each([[null], ['files'], [[null]], [[{ name: 'a.glb' }]], [[{ name: 'a.glb', bytes: [1, 2] }]]])(
  'files without bytes are none: %#',
  (files) => {
    expect(areFiles(files)).toBe(false);
  },
);
