import { describe, expect, it } from 'vitest';
import { applyPermalink, ignoredValues, readPermalink, writePermalink } from '../../web/app/sources/permalink.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, DEFAULT_VIEW, EMPTY_STATE } from '../../web/model/state.ts';
import type { AppState, Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const initial = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 0.5), keyRef(2, 'c', 1));
const state: AppState = {
  ...EMPTY_STATE,
  source: { kind: 'sample', id: 'cactus' },
  time: 1.25,
  doc: {
    keys: [
      keyRef(2, 'c', -0.25, { bias: -0.5 }),
      keyRef(0, 'a', 0.5, {
        tension: 0.25,
        turns: [{ turns: -2 }, { component: 0, turns: 1 }, { component: 11, turns: -3 }],
      }),
      keyRef(1, 'b', 1, { bias: 1 }),
    ],
    motion: {
      ...DEFAULT_MOTION,
      boundary: 'hermite',
      startSpeed: 0,
      endSpeed: 2.5,
      keepLengths: 2,
      spaceFaces: 500,
      spaceSamples: 12,
    },
    encoding: {
      ...DEFAULT_ENCODING,
      stretch: 'log',
      patches: 40,
      referencePose: 1,
      ghostFaces: 1500,
      transfer: 'paper',
      placement: 'optimal',
    },
  },
  view: {
    ...DEFAULT_VIEW,
    wireframe: true,
    floor: false,
    ghostWire: true,
    ghostDifference: true,
    ghostSizes: true,
    compare: ['linear', 'cubic-vertex'],
    split: 0.25,
    camera: { position: [1, 2, 3], target: [0, 0.5, 0] },
    window: [0.25, 0.5],
  },
  play: { playing: false, speed: 0.5, loop: 'loop', between: [-0.125, 0.75], fps: 12.5 },
};

describe('permalinks', () => {
  it('restore the whole state of a sample', () => {
    const link = readPermalink(`#${writePermalink(state, initial)}`)!;
    expect(link.sample).toBe('cactus');
    expect(applyPermalink(initial, link)).toEqual(state.doc);
    expect({ ...DEFAULT_VIEW, ...link.view }).toEqual(state.view);
    expect([link.time, link.speed, link.loop, link.between, link.fps]).toEqual([
      1.25,
      0.5,
      'loop',
      [-0.125, 0.75],
      12.5,
    ]);
  });

  it('from before parts had turns open unchanged', () => {
    const link = readPermalink(
      'sample=cactus&keys=2%40-0.25%2C0%40.5%2C1%401&tension=0%2C0.25%2C0&turns=0%2C-2%2C0&boundary=hermite&startSpeed=0&t=1.25&speed=0.5',
    )!;
    expect(applyPermalink(initial, link)).toEqual({
      ...initial,
      motion: { ...DEFAULT_MOTION, boundary: 'hermite', startSpeed: 0 },
      keys: [keyRef(2, 'c', -0.25), keyRef(0, 'a', 0.5, { tension: 0.25, turns: [{ turns: -2 }] }), keyRef(1, 'b', 1)],
    });
  });

  it('ignore turns of parts and keys that the sample does not have', () => {
    const link = readPermalink('sample=x&partTurns=1:2:1,3:0:1,1:0:2,0:0:0,1:x:1,1:0.5:1,1:-1:1,1:1:1e9,1:1,2:1:-1')!;
    const turns = applyPermalink(initial, link, 2).keys.map(({ shaping }) => shaping.turns);
    expect(turns).toEqual([[], [{ component: 0, turns: 2 }], [{ component: 1, turns: -1 }]]);
  });

  it('contain options that were reset to a default other than that of the sample', () => {
    const periodic: Doc = { ...initial, motion: { ...DEFAULT_MOTION, boundary: 'periodic' } };
    const natural: AppState = { ...state, doc: initial };
    const link = readPermalink(writePermalink(natural, periodic)!)!;
    expect(applyPermalink(periodic, link).motion.boundary).toBe('natural');
  });

  it('are short without changes', () => {
    const untouched: AppState = { ...EMPTY_STATE, source: { kind: 'sample', id: 'bar' }, doc: initial };
    expect(writePermalink(untouched, initial)).toBe('sample=bar&t=0&speed=0.25');
  });

  it('are not made for the files of the user', () => {
    expect(writePermalink({ ...state, source: { kind: 'files', names: ['mine.glb'] } }, initial)).toBeNull();
  });

  it('ignore invalid values', () => {
    const link = readPermalink(
      'sample=x&keys=0@0,9@1&boundary=evil&startSpeed=NaN&t=Infinity&patches=-3&camera=1,2&compare=lri,nonsense&tension=1,2&bias=0,9,0&turns=0,1.5,0&speed=0&ghostFaces=3&transfer=fast&placement=1&ghostWire=yes&between=1,0&fps=1e9&window=2',
    )!;
    expect(applyPermalink(initial, link)).toEqual(initial);
    expect(link.time).toBeNull();
    expect([link.speed, link.between, link.fps]).toEqual([null, null, null]);
    expect(link.view).toEqual({ compare: ['lri'] });
  });

  it('compare with at most three other methods', () => {
    const link = readPermalink('sample=x&compare=geodesic,linear,rimd,rotation-strain,cubic-vertex')!;
    expect(link.view.compare).toEqual(['geodesic', 'linear', 'rimd']);
  });

  it.each([
    ['patches', '1e300'],
    ['patches', '1e9'],
    ['ghostFaces', '3e9'],
    ['ghostFaces', '1e9'],
    ['period', '1e-9'],
    ['period', '1e308'],
    ['period', '1'], // not longer than the range of the keys
    ['startSpeed', '1e308'],
    ['endSpeed', '-1e6'],
    ['tension', '1e308,0,0'],
    ['tension', '0,0,-1e9'],
    ['bias', '0,0,2'],
    ['turns', '0,1e9,0'],
    ['partTurns', '1:0:1e9'],
    ['t', '1e300'],
    ['t', '-1e10'],
    ['fps', '1e9'],
    ['fps', '1e-300'],
    ['speed', '1e308'],
    ['between', '0,1e300'],
    ['window', '-1e300,1'],
    ['keys', '0@0,1@1e10'],
    ['keys', '9@0,8@1'],
    ['compare', 'nosuch'],
    ['camera', '1e300,0,0,0,0,0'],
    ['camera', '1,2,3,1,2,3'],
    ['referencePose', '1e300'],
  ])('leave out %s=%s, and say so', (name, value) => {
    const link = readPermalink(`sample=x&${name}=${value}`)!;
    const doc = applyPermalink(initial, link);
    expect(doc).toEqual(initial);
    expect([link.time, link.speed, link.between, link.fps, link.view]).toEqual([null, null, null, null, {}]);
    expect(ignoredValues(link, doc)).toBe(`The link has a value that cannot be used and was ignored: ${name}.`);
  });

  it('that are valid are read completely', () => {
    const link = readPermalink(writePermalink(state, initial)!)!;
    expect(ignoredValues(link, applyPermalink(initial, link))).toBeNull();
  });

  it('refuse unordered or repeated key times', () => {
    for (const keys of ['0@0,1@0', '0@1,1@0', '0@0', '0@0,1@x', '1.5@0,1@1']) {
      const link = readPermalink(`sample=x&keys=${keys}`)!;
      expect(applyPermalink(initial, link).keys, keys).toBe(initial.keys);
    }
  });

  it('need a sample', () => {
    expect(readPermalink('#t=0.5')).toBeNull();
    expect(readPermalink('')).toBeNull();
  });
});
