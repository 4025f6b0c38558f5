/** The document's requests to the engine as plain data: keys, encoding, motion. */
import { NO_GHOST, ghostFor, motionFor } from '../../engine/api/method-options.ts';
import { METHOD, isFitted } from '../../engine/api/methods.ts';
import type { Keys } from '../../engine/api/api.ts';
import type { ShapeName } from '../../engine/api/option-table.ts';
import type { EncodingOptions, Method, MotionOptions, Pin } from '../../engine/api/types.ts';
import type { Variant } from '../../playback/frame-set.ts';
import { listsOf } from '../../model/shaping.ts';
import type { Doc, View } from '../../model/state.ts';
import { departsFromPaper, keptLengths } from '../../model/spline-options.ts';
import { DEFAULT_VIEW, referenceKey } from '../../model/state.ts';

type Encoding = Omit<EncodingOptions, ShapeName | 'precision'>;

/** The parts of the view that determine the running motions. */
export type ShownMotions = Pick<View, 'compare' | 'ghostDifference' | 'ghostSizes'>;

/** Ghost mesh sizes shown side by side, as multiples of the chosen size (Fig. 7). */
const SIZES = [2, 4];

/** One motion per variant; everything else is shared. */
export interface SequencePlan {
  order: number[];
  names: string[];
  times: number[];
  encoding: Encoding;
  startTangentPose: number | null;
  endTangentPose: number | null;
  motion: Omit<MotionOptions, 'method'>;
  variants: Variant[];
}

/** Beside a motion with a ghost, other sizes and the motion without a ghost can be shown. */
export function sequencePlan(doc: Doc, shown: ShownMotions = DEFAULT_VIEW): SequencePlan {
  const { keys, motion, encoding } = doc;
  const { method, ...rest } = motion;
  const { referencePose: _, startTangentPose, endTangentPose, ...plain } = encoding;
  const hermite = motion.boundary === 'hermite';
  const ghost = plain.ghostFaces;
  const leading = (one: Method): number => ghostFor(plain, one).ghostFaces;
  const sizes = ghost > 0 && METHOD[method].space === 'lri' ? otherSizes(ghost, shown) : [];
  return {
    order: keys.map((key) => key.pose),
    // Files name every target.
    names: keys.map(({ name, time }) => name || `${Number(time.toPrecision(6))} s`),
    times: keys.map((key) => key.time),
    encoding: { reference: referenceKey(doc), ...plain },
    startTangentPose: hermite ? startTangentPose : null,
    endTangentPose: hermite ? endTangentPose : null,
    motion: {
      ...rest,
      pins: pinsFor(doc),
      ...listsOf(keys.map((key) => key.shaping)),
      keepLengths: keptLengths(doc),
      inPlace: false,
    },
    variants: [
      { method, ghost: leading(method) },
      ...sizes.map((size) => ({ method, ghost: size })),
      ...shown.compare.flatMap((other) => besideMethod(doc, other).map((one) => ({ ...one, ghost: leading(other) }))),
    ],
  };
}

/** Compares a motion that departs from the published method with the published one. */
function besideMethod(doc: Doc, other: Method): Omit<Variant, 'ghost'>[] {
  if (other !== doc.motion.method) return [{ method: other }];
  return departsFromPaper(doc) ? [{ method: other, plain: true }] : [];
}

/** A pin whose key was removed follows its own spline. */
function pinsFor({ keys, motion }: Doc): Pin[] {
  return motion.pins.map(({ stay, ...pin }) => {
    const key = keys.findIndex(({ pose }) => pose === stay);
    return key < 0 ? pin : { ...pin, stay: key };
  });
}

function otherSizes(ghost: number, { ghostDifference, ghostSizes }: ShownMotions): number[] {
  if (ghostSizes) return [...SIZES.map((times) => times * ghost), 0];
  return ghostDifference ? [0] : [];
}

function withGhost({ encoding }: SequencePlan, { ghost }: Variant): Encoding {
  return ghost > 0 ? { ...encoding, ghostFaces: ghost } : { ...encoding, ...NO_GHOST };
}

/** Variants with the same key are motions of the same shape. */
export function shapeKey(plan: SequencePlan, variant: Variant): string {
  const { order, startTangentPose, endTangentPose } = plan;
  return JSON.stringify([order, withGhost(plan, variant), startTangentPose, endTangentPose]);
}

/** Identifies the slow parts of a plan: its shapes, and motions with fitted shapes. */
export function buildKey(plan: SequencePlan): string {
  const keys = plan.variants.flatMap((variant) => {
    const motion = motionFor(plan.motion, variant);
    return [shapeKey(plan, variant), isFitted(motion) && JSON.stringify([motion, plan.times])];
  });
  return [...new Set(keys)].join();
}

/** A variant's encoding; `keys` hold every pose. */
export function encodingFor(plan: SequencePlan, variant: Variant, keys: Keys): Partial<EncodingOptions> {
  const pose = (index: number | null): Float32Array | null => (index === null ? null : keys.positions(index));
  return {
    ...withGhost(plan, variant),
    startTangent: pose(plan.startTangentPose),
    endTangent: pose(plan.endTangentPose),
  };
}
