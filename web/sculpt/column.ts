/** A striped column, twisted from foot to head: the worst case for blending positions. */
import type { Sculpture } from './glb.ts';
import { painted } from './png.ts';
import { placed, skin } from './skin.ts';
import type { Place } from './skin.ts';

const HEIGHT = 4.2;
const RADIUS = 0.92;
const CORNER = 0.3;
const LOBES = 6;
const LOBE_DEPTH = 0.13;
const TURNS = [0, 180, 350];
export type Colour = readonly [number, number, number];
const CREAM: Colour = [236, 222, 197];
const BRICK: Colour = [188, 84, 62];

export function column(detail: number): Promise<Sculpture> {
  return striped(detail, BRICK, TURNS.map(twisted));
}

/** A column of lobes in cream and a second colour. */
export async function striped(detail: number, colour: Colour, poses: readonly Place[]): Promise<Sculpture> {
  const surface = skin(Math.round(84 * detail), LOBES * Math.round(13 * detail));
  const picture = await painted(256, 4, (u) => {
    // The colours meet in the grooves.
    const share = smooth(0.5 + 9 * Math.cos(LOBES * Math.PI * u));
    return CREAM.map((level, i) => level + (colour[i]! - level) * share) as [number, number, number];
  });
  return { skin: surface, keys: poses.map((pose) => placed(surface, pose)), picture, roughness: 0.42 };
}

function twisted(degrees: number): Place {
  return lobed((height) => ({ size: 1, raised: height, turn: ((degrees * Math.PI) / 180) * smooth(height / HEIGHT) }));
}

/** The column at a height: width, vertical position, and rotation in radians. */
export type Level = (height: number) => { size: number; raised: number; turn: number };

export function lobed(level: Level): Place {
  return (along) => {
    const [radius, height] = profile(along);
    const { size, raised, turn } = level(height);
    return (angle) => {
      const away = size * radius * (1 + LOBE_DEPTH * Math.cos(LOBES * angle) * Math.min(radius / RADIUS, 1));
      return [away * Math.cos(angle + turn), raised, away * Math.sin(angle + turn)];
    };
  };
}

/** Radius and height along the outline: flat bottom, round corner, side, and the same at the top. */
function profile(along: number): readonly [number, number] {
  const [flat, round] = [RADIUS - CORNER, (CORNER * Math.PI) / 2];
  const half = flat + round + HEIGHT / 2 - CORNER;
  const above = along > 0.5;
  const at = (above ? 1 - along : along) * 2 * half;
  const turn = Math.min(Math.max((at - flat) / CORNER, 0), Math.PI / 2);
  const radius = at < flat ? at : flat + CORNER * Math.sin(turn);
  const height = at < flat ? 0 : at < flat + round ? CORNER * (1 - Math.cos(turn)) : CORNER + at - flat - round;
  return [radius, above ? HEIGHT - height : height];
}

function smooth(x: number): number {
  const t = Math.min(Math.max(x, 0), 1);
  return t * t * (3 - 2 * t);
}
