import { describe, expect, it } from 'vitest';
import { FaceHeat } from '../../web/app/drawing/face-heat.ts';
import { heatColours } from '../../web/app/drawing/difference.ts';
import { bar, bent } from '../engine/support/shapes.ts';

const mesh = bar();
const heat = new FaceHeat(mesh.positions, mesh.indices);
const faces = mesh.indices.length / 3;

const mapped = (map: (p: number[]) => number[]): Float32Array =>
  Float32Array.from(
    Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
      map([...mesh.positions.subarray(3 * v, 3 * v + 3)]),
    ).flat(),
  );

/** Rotates about an axis without symmetry. */
function turned(degrees: number): Float32Array {
  const [x, y, z] = [1 / 3, 2 / 3, 2 / 3];
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return mapped(([px, py, pz]) => {
    const along = (px! * x + py! * y + pz! * z) * (1 - c);
    return [
      px! * c + (y * pz! - z * py!) * s + x * along,
      py! * c + (z * px! - x * pz!) * s + y * along,
      pz! * c + (x * py! - y * px!) * s + z * along,
    ];
  });
}

describe('rotation and stretch of faces', () => {
  it('are zero in the reference', () => {
    for (const kind of ['rotation', 'stretch'] as const) {
      expect(heat.amounts(mesh.positions, kind).largest, kind).toBeLessThan(0.1);
    }
  });

  it('of a rotated shape are its angle, without stretch', () => {
    for (const degrees of [10, 90, 170]) {
      const { values } = heat.amounts(turned(degrees), 'rotation');
      for (const value of values) expect(value).toBeCloseTo(degrees, 1);
      expect(heat.amounts(turned(degrees), 'stretch').largest).toBeLessThan(0.01);
    }
  });

  it('of a scaled shape are its factor, up or down', () => {
    for (const factor of [1.5, 1 / 1.5]) {
      const positions = mesh.positions.map((value) => value * factor);
      for (const value of heat.amounts(positions, 'stretch').values) expect(value).toBeCloseTo(50, 3);
      expect(heat.amounts(positions, 'rotation').largest).toBeLessThan(0.1);
    }
  });

  it('of a bend grow along it to its angle', () => {
    const positions = bent(mesh, 60);
    const angles = Array.from({ length: faces }, (_, face) => heat.amountOf(positions, face, 'rotation'));
    expect(Math.max(...angles)).toBeGreaterThan(57);
    expect(Math.max(...angles)).toBeLessThan(62);
    expect(Math.min(...angles)).toBeLessThan(4);
  });

  it('omit faces without area, and use colours up to the top of the bar', () => {
    const flat = new FaceHeat(new Float32Array(9), Uint32Array.of(0, 1, 2));
    expect(flat.amounts(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), 'stretch')).toMatchObject({ largest: 0, mean: 0 });
    const colours = heatColours({ percent: Float32Array.of(0, 50, 100) }, 100);
    expect(colours[2]).toBeGreaterThan(colours[0]!); // the lowest colour is violet
    expect(colours[6]).toBeGreaterThan(colours[8]!); // the highest colour is yellow
  });
});
