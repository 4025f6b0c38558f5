/** Names of the methods. */
import type { Method } from '../engine/api/types.ts';

/** The method as published, next to the same method with holding or other options. */
export const PLAIN_WORDS = { label: 'Shape spline (LRI), as published', short: 'As published' } as const;

export function motionWords({ method, plain }: { method: Method; plain?: true }): { label: string; short: string } {
  return plain ? PLAIN_WORDS : METHOD_WORDS[method];
}

/** For beside a method's name: in how many intervals between keys it shows shapes of its own; '' for all. */
export function fittedText(fitted: readonly boolean[] | null): string {
  const count = fitted?.filter((isFitted) => isFitted).length;
  return !fitted || count === fitted.length ? '' : `fitted in ${count} of ${fitted.length} intervals`;
}

/** CSS class of the method's line in plots. */
export function lineStyle({ method, plain }: { method: Method; plain?: true }): string {
  return plain ? 'nothing-held' : method;
}

export const METHOD_WORDS: Record<Method, { label: string; short: string; hint: string }> = {
  lri: {
    label: 'Shape spline (LRI)',
    short: 'Shape spline',
    hint: 'The method of this page: cubic splines of rotations and stretches. Smooth; the volume changes little.',
  },
  geodesic: {
    label: 'Geodesic (LRI)',
    short: 'Geodesic',
    hint: 'Straight from key to key in the same space. The velocity jumps at the keys.',
  },
  linear: {
    label: 'Morph targets (linear)',
    short: 'Morph targets',
    hint: 'Blends positions, as most programs do. Shrinks and shears where the shape rotates.',
  },
  'cubic-vertex': {
    label: 'Morph targets (cubic)',
    short: 'Morph spline',
    hint: 'Cubic splines of positions. Smooth, but shrinks and shears where the shape rotates.',
  },
  'rotation-strain': {
    label: 'Rotation-strain spline',
    short: 'Rotation-strain',
    hint: 'Cubic splines of the rotation and stretch of each face. Tears where faces rotate by nearly 360 degrees.',
  },
  rimd: {
    label: 'Mesh difference spline (RIMD)',
    short: 'RIMD',
    hint: 'Cubic splines of the stretch of each face and its rotation relative to its neighbours. Smooth, but slow.',
  },
  lengths: {
    label: 'Lengths and angles (NRIC)',
    short: 'Lengths',
    hint: 'Cubic splines of edge lengths and angles between faces: for cloth.',
  },
  shell: {
    label: 'Spline in shell space',
    short: 'Shell spline',
    hint: 'The smoothest motion of an elastic shell, [2] in the paper.',
  },
};
