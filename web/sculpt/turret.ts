/** A striped column whose upper part shrinks uniformly, to compare stretches beyond the keys. */
import { lobed, striped } from './column.ts';
import type { Colour, Level } from './column.ts';
import type { Sculpture } from './glb.ts';

/** Size and rotation in degrees of the upper part, in each pose. */
const POSES = [
  [1, 0],
  [0.6, 50],
  [0.2, 0],
] as const;
/** Heights of the transition to the upper part. */
const [FROM, TO] = [1.2, 2.2];
const TEAL: Colour = [58, 134, 138];

export function turret(detail: number): Promise<Sculpture> {
  return striped(
    detail,
    TEAL,
    POSES.map(([size, degrees]) => lobed(shrunk(size, degrees))),
  );
}

/** Vertical position is the integral of the size over the height, so narrower slices are thinner as well. */
function shrunk(size: number, degrees: number): Level {
  return (height) => {
    const share = Math.min(Math.max((height - FROM) / (TO - FROM), 0), 1);
    const begun = share * share * (3 - 2 * share);
    const below = (TO - FROM) * (share ** 3 - share ** 4 / 2) + Math.max(height - TO, 0);
    const turn = ((degrees * Math.PI) / 180) * begun;
    return { size: 1 - (1 - size) * begun, raised: height - (1 - size) * below, turn };
  };
}
