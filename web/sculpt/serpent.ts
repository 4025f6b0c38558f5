/** A serpent with modelled scales. It winds to either side, coils and raises its head. */
import type { Sculpture } from './glb.ts';
import { painted } from './png.ts';
import { placed, skin } from './skin.ts';
import type { Place } from './skin.ts';

const LENGTH = 9;
/** Number of scales along and around the body, and their height in radii. */
const SCALES = { along: 112, around: 26, height: 0.075 };

/** Direction of the body in radians, from its tail at 0 to its head at 1. */
interface Bearing {
  yaw(along: number): number;
  pitch(along: number): number;
}

/**
 * The two winding poses are a quarter of a wave apart. Halfway between opposite waves the serpent would be straight,
 * and longer than the fitted view.
 */
const POSES: readonly Bearing[] = [winding(0), winding(Math.PI / 2), coiled()];

export async function serpent(detail: number): Promise<Sculpture> {
  const surface = skin(Math.round(800 * detail), Math.round(192 * detail));
  const picture = await painted(256, 256, colourAt);
  return { skin: surface, keys: POSES.map((pose) => placed(surface, bodyAlong(pose))), picture, roughness: 0.5 };
}

function winding(phase: number): Bearing {
  return {
    yaw: (along) => 1.05 * Math.sin(3 * Math.PI * along + phase) * Math.min(1, 4 * (1 - along) + 0.3),
    pitch: () => 0,
  };
}

/** Nearly one turn with increasing curvature; the neck rises at its end. */
function coiled(): Bearing {
  return {
    yaw: (along) => LENGTH * (along / 2.3 + 0.22 * along * along) - 2.2,
    pitch: (along) => 1.25 * (smooth((along - 0.68) / 0.12) - smooth((along - 0.9) / 0.09)),
  };
}

type Vector = readonly [number, number, number];

interface Frame {
  centre: Vector;
  side: Vector;
  up: Vector;
}

const STEPS = 2000;

function bodyAlong(pose: Bearing): Place {
  const frames = line(pose);
  return (along) => {
    const at = Math.min(along * STEPS, STEPS - 1e-9);
    const [a, b] = [frames[Math.floor(at)]!, frames[Math.floor(at) + 1]!];
    const mixed = (of: (frame: Frame) => Vector): Vector => {
      const [from, to] = [of(a), of(b)];
      return [0, 1, 2].map((axis) => from[axis]! + (to[axis]! - from[axis]!) * (at % 1)) as unknown as Vector;
    };
    const [cx, cy, cz] = mixed(({ centre }) => centre);
    const [sx, sy, sz] = mixed(({ side }) => side);
    const [ux, uy, uz] = mixed(({ up }) => up);
    const plain = radiusAt(along);
    const scales = scalesAt(along);
    return (angle) => {
      const radius = plain * (1 + SCALES.height * scales(angle));
      // Wider than high, with a flat underside.
      const [across, over] = [1.06 * radius * Math.cos(angle), radius * Math.max(Math.sin(angle), -0.8)];
      return [cx + across * sx + over * ux, cy + across * sy + over * uy, cz + across * sz + over * uz];
    };
  };
}

/** The centre line with its axes, centred at the origin. */
function line({ yaw, pitch }: Bearing): Frame[] {
  const frames: Frame[] = [];
  let [x, y, z] = [0, 0, 0];
  for (let i = 0; i <= STEPS; i += 1) {
    const along = i / STEPS;
    const [heading, rise] = [yaw(along), pitch(along)];
    const [cy, sy, cp, sp] = [Math.cos(heading), Math.sin(heading), Math.cos(rise), Math.sin(rise)];
    frames.push({ centre: [x, y + 0.8 * radiusAt(along), z], side: [-sy, 0, cy], up: [-sp * cy, cp, -sp * sy] });
    const step = LENGTH / STEPS;
    x += step * cp * cy;
    y += step * sp;
    z += step * cp * sy;
  }
  const middle = [0, 2].map((axis) => frames.reduce((sum, { centre }) => sum + centre[axis]!, 0) / frames.length);
  return frames.map((frame) => ({
    ...frame,
    centre: [frame.centre[0] - middle[0]!, frame.centre[1], frame.centre[2] - middle[1]!],
  }));
}

/** Thin tail, full body, slender neck, broad head. */
function radiusAt(along: number): number {
  const body = 0.27 * smooth(along / 0.5) ** 0.75 * (1 - 0.45 * smooth((along - 0.62) / 0.22));
  const head = 0.085 * Math.exp(-(((along - 0.955) / 0.028) ** 2));
  const ends = Math.sqrt(Math.min(along / 0.006, 1)) * Math.sqrt(Math.min((1 - along) / 0.03, 1));
  return (body + head + 0.014) * ends;
}

/** Height of the scales in [0, 1]: rows offset by half a scale, smooth below and at both ends. */
function scalesAt(along: number): (angle: number) => number {
  const row = along * SCALES.along;
  const below = Math.floor(row);
  const fade = smooth(along * 12) * smooth((0.93 - along) * 14);
  const inRow = (of: number, angle: number): number => {
    const place = (angle / (2 * Math.PI)) * SCALES.around + (of % 2 === 0 ? 0 : 0.5);
    const [dx, dy] = [2 * (place - Math.floor(place)) - 1, row - of];
    return 1 - Math.min(0.75 * dx * dx + dy * dy, 1);
  };
  return (angle) =>
    Math.max(inRow(below, angle), inRow(below + 1, angle)) ** 0.6 * smooth(1.6 * Math.sin(angle) + 0.9) * fade;
}

const [BACK, BAND, BELLY] = [[38, 94, 84] as const, [226, 164, 58] as const, [232, 221, 188] as const];

/** Diamonds along the back, pale below. */
function colourAt(u: number, v: number): readonly [number, number, number] {
  const up = Math.sin(2 * Math.PI * u);
  const wave = Math.abs(((v * 17) % 1) - 0.5) * 2;
  const diamond = smooth(9 * (0.62 * wave + 0.42 * up - 0.5)) * smooth((v - 0.03) * 20) * smooth((0.9 - v) * 20);
  const below = smooth(-3 * up - 0.6);
  return BACK.map((level, i) => {
    const back = level + (BAND[i]! - level) * diamond;
    return back + (BELLY[i]! - back) * below;
  }) as unknown as readonly [number, number, number];
}

function smooth(x: number): number {
  const t = Math.min(Math.max(x, 0), 1);
  return t * t * (3 - 2 * t);
}
