/** Settings that refer to poses and vertices, after the same files are read with other keys or objects. */
import { describe, expect, it } from 'vitest';
import { PosePool } from '../../web/app/session/pose-pool.ts';
import { carriedSettings } from '../../web/app/sources/carried-settings.ts';
import { KeyArrays } from '../../web/engine/caller/keyframes.ts';
import type { KeyData } from '../../web/engine/wire/protocol.ts';
import type { KeysInfo, PathKey, Pin } from '../../web/engine/api/types.ts';
import { setEncoding, setMotion } from '../../web/model/edits.ts';
import type { Encoding } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

/** Triangles that share no vertex. `parts`: names of the objects, one triangle each. */
function pool(
  times: number[],
  parts: string[],
  { places = parts.map((_, i) => i), ...change }: Partial<KeysInfo> & { places?: number[] } = {},
) {
  const faces = Uint32Array.from({ length: 3 * parts.length }, (_, corner) => corner);
  const objects = parts.map((name, start) => ({ name, start, count: 1 }));
  const own = {
    names: times.map(String),
    times,
    faces,
    offset: [0, 0, 0],
    scene: { objects },
    animation: 0,
    project: null,
  };
  const info = { ...own, report: { vertices: faces.length }, ...change };
  const positions = times.map((t) =>
    Float32Array.from(faces.length === 0 ? [] : places.flatMap((x) => [0, 1, 2].flatMap((c) => [x, c, t]))),
  );
  return new PosePool(new KeyArrays({ info, positions, normals: null } as unknown as KeyData));
}
const docOf = (times: number[], pins: Pin[], encoding: Partial<Encoding> = {}) =>
  setEncoding(setMotion(docOfKeys(...times.map((t, i) => keyRef(i, `${t} s`, t))), { pins }), encoding);
const [three, five] = [
  [0, 1, 2],
  [0, 0.5, 1, 1.5, 2.25],
];
const pin = (vertex: number, change: Partial<Pin> = {}): Pin => ({ vertex, radius: 0.1, ...change });

describe('other keys of the animation', () => {
  const now = (
    pins: Pin[],
    before: PosePool | null,
    times = five,
    change: Partial<KeysInfo> = {},
    doc = docOf(three, pins),
  ) => carriedSettings(docOf(times, []), pool(times, ['a'], change), doc, before);

  it('a pin stays at the pose nearest in time, also with fewer keys', () => {
    const before = pool(three, ['a']);
    expect(now([pin(0, { stay: 2 }), pin(1, { stay: 1 })], before).doc.motion.pins).toEqual([
      pin(0, { stay: 4 }),
      pin(1, { stay: 2 }),
    ]);
    expect(now([pin(0, { stay: 2 })], null, [0, 1.8]).doc.motion.pins).toEqual([pin(0, { stay: 1 })]);
  });

  it('counts the time of the pose, not the time to which its key was moved', () => {
    const moved = {
      ...docOf(three, [pin(0, { stay: 1 })]),
      keys: [keyRef(0, '', 0), keyRef(1, '', 1.9), keyRef(2, '', 2)],
    };
    expect(now([], pool(three, ['a']), five, {}, moved).doc.motion.pins).toEqual([pin(0, { stay: 2 })]);
  });

  it('a pin at a pose of another file or of another animation follows its own spline, with a sentence', () => {
    const before = pool(three, ['a']);
    const added = before.add('extra', new Float32Array(9));
    const doc = docOf(three, [pin(0, { stay: added })]);
    const own = {
      doc: { motion: { pins: [pin(0)] } },
      lost: [expect.stringContaining('Pin 1 follows its own spline')],
    };
    expect(now([], before, five, {}, { ...doc, keys: [...doc.keys, keyRef(added, 'extra', 3)] })).toMatchObject(own);
    const other = now([pin(0, { stay: 2 })], before, five, { animation: 1 });
    expect(other).toMatchObject(own);
    expect(other.doc.motion.pins[0]).not.toHaveProperty('stay');
  });

  it('a pin whose key had been removed stays free, without a sentence', () => {
    const doc = docOf(three, [pin(0, { stay: 7 })]);
    expect(now([], pool(three, ['a']), five, {}, doc)).toMatchObject({ doc: { motion: { pins: [pin(0)] } }, lost: [] });
  });

  it('times of a project are converted to those of its animation', () => {
    const project = pool([1, 2, 5], ['a'], {
      animation: -1,
      project: {},
      speed: 2,
      played: null,
      animations: [{ start: 0 }] as never,
    });
    const path: PathKey[] = [{ time: 3, move: [1, 0, 0] }];
    const { doc } = now([], project, [0, 0.5, 1, 2], {}, docOf([1, 2, 5], [pin(0, { stay: 1, path })]));
    expect(doc.motion.pins).toEqual([pin(0, { stay: 1, path: [{ time: 1, move: [1, 0, 0] }] })]);
  });

  it('the reference and shapes of end tangents are kept', () => {
    const before = pool(three, ['a']);
    const tangent = before.add('over', Float32Array.of(9, 8, 7, 6, 5, 4, 3, 2, 1));
    const doc = docOf(three, [], { referencePose: 2, endTangentPose: tangent });
    const later = pool(five, ['a'], { offset: [1, 0, 0] });
    const { encoding } = carriedSettings(docOf(five, []), later, doc, before).doc;
    expect(encoding).toMatchObject({ referencePose: 4, startTangentPose: null, endTangentPose: 5 });
    expect([...later.keys.positions(5)]).toEqual([8, 8, 7, 5, 5, 4, 2, 2, 1]);
  });
});

describe('other objects of the files', () => {
  const carried = (before: PosePool, parts: string[], pins: Pin[], encoding: Partial<Encoding> = {}) =>
    carriedSettings(docOf(three, []), pool(three, parts), docOf(three, pins, encoding), before);

  it('pins move with their vertices; pins of left out objects are removed, with a sentence', () => {
    const { doc, lost } = carried(
      pool(three, ['floor', 'body', 'tail']),
      ['body', 'tail'],
      [pin(4, { stay: 1 }), pin(0), pin(8)],
    );
    expect(doc.motion.pins).toEqual([pin(1, { stay: 1 }), pin(5)]);
    expect(lost).toEqual(['Pin 2 was removed, because its object is left out.']);
  });

  it('pins find their vertices when objects are put back, and among objects of one name or of one shape', () => {
    expect(carried(pool(three, ['body']), ['floor', 'body'], [pin(1)]).doc.motion.pins).toEqual([pin(4)]);
    expect(carried(pool(three, ['a', 'leg', 'leg']), ['leg', 'leg'], [pin(3), pin(6)]).doc.motion.pins).toEqual([
      pin(0),
      pin(3),
    ]);
    expect(carried(pool(three, ['a']), ['b'], [pin(0)])).toMatchObject({ doc: { motion: { pins: [] } }, lost: [{}] });
  });

  it('the shape of an end tangent loses the object too, or is removed with a sentence if it lacks one', () => {
    const [whole, body] = [pool(three, ['floor', 'body']), pool(three, ['body'])];
    const shape = (before: PosePool) => before.add('over', Float32Array.from(before.keys.positions(0).keys()));
    const less = carried(whole, ['body'], [], { startTangentPose: shape(whole) });
    expect([less.doc.encoding.startTangentPose, less.lost]).toEqual([3, []]);
    const more = carried(body, ['floor', 'body'], [], { startTangentPose: shape(body) });
    expect([more.doc.encoding.startTangentPose, more.lost]).toEqual([
      null,
      ['The start tangent was removed, because its shape lacks an object.'],
    ]);
  });
});
