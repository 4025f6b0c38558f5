/**
 * What each option of a motion needs, and what excludes it. Refusals of the engine and the command line, options left
 * out of comparisons, and the page's reasons follow from these rows. The core repeats some checks as the last line.
 */
import { METHOD, OWN_METHOD, hasEnds, isFitted } from './methods.ts';
import { MOTION_DEFAULTS } from './types.ts';
import type { MotionOptions, SequenceOptions } from './types.ts';

export type RuledOption =
  | 'boundary'
  | 'tension'
  | 'bias'
  | 'earlier'
  | 'swing'
  | 'regions'
  | 'hold'
  | 'pins'
  | 'turns'
  | 'keepLengths';
export type Ruled = Pick<MotionOptions, 'method' | RuledOption>;

type Deciding = Pick<Ruled, 'method' | 'boundary' | 'keepLengths'>;

interface Rule {
  /** The object of "does not support". */
  words: string;
  /** Whether the method supports it, or ignores it without harm. */
  fitsMethod(options: Deciding): boolean;
}

const isUnfitted = ({ method }: Deciding): boolean => METHOD[method].curve !== 'fitted';
const isOwn = ({ method }: Deciding): boolean => method === OWN_METHOD;
const holds = ({ method }: Deciding): boolean => METHOD[method].holds;

export const RULES: Readonly<Record<RuledOption, Rule>> = {
  boundary: {
    words: "ends other than 'natural'",
    fitsMethod: ({ method, boundary }) => hasEnds(method, boundary),
  },
  tension: { words: 'tension', fitsMethod: isUnfitted },
  bias: { words: 'bias', fitsMethod: isUnfitted },
  earlier: { words: 'timing', fitsMethod: isOwn },
  swing: { words: 'timing', fitsMethod: isOwn },
  regions: { words: 'regions with timings of their own', fitsMethod: isOwn },
  hold: { words: 'keeping resting parts in place', fitsMethod: holds },
  pins: { words: 'pins', fitsMethod: holds },
  turns: { words: 'full turns', fitsMethod: ({ method }) => METHOD[method].turns },
  keepLengths: { words: 'kept lengths', fitsMethod: isOwn },
};

const hasSpeeds = ({ boundary }: Deciding): boolean => boundary === 'hermite';
const isSpline = ({ method }: Deciding): boolean => METHOD[method].curve === 'spline';
const isInLriSpace = ({ method }: Deciding): boolean => METHOD[method].space === 'lri';

/** Further options without effect unless this is true. The engine accepts them anyway. */
const EFFECTIVE_IF: { readonly [N in keyof SequenceOptions]?: (options: Deciding) => boolean } = {
  boundary: () => true,
  tension: isSpline,
  bias: isSpline,
  startSpeed: hasSpeeds,
  endSpeed: hasSpeeds,
  startTangent: hasSpeeds,
  endTangent: hasSpeeds,
  period: ({ boundary }) => boundary === 'periodic',
  spaceFaces: isFitted,
  spaceSamples: ({ method }) => METHOD[method].curve === 'fitted',
  stretch: ({ method }) => METHOD[method].space !== 'vertices',
  ghostFaces: isInLriSpace,
  transfer: isInLriSpace,
  placement: isInLriSpace,
};

export function hasEffect(option: keyof SequenceOptions, options: Deciding): boolean {
  return (EFFECTIVE_IF[option] ?? RULES[option as RuledOption]?.fitsMethod ?? (() => true))(options);
}

const EXCLUDED_BY_KEPT_LENGTHS: readonly RuledOption[] = [
  'boundary',
  'earlier',
  'swing',
  'regions',
  'hold',
  'pins',
  'turns',
];

/** Whether an option asks for something: a value other than its default, or an entry of a list other than zero. */
function isUsed(options: Ruled, option: RuledOption): boolean {
  const value = options[option];
  if (!Array.isArray(value)) return value !== MOTION_DEFAULTS[option];
  return value.some((one) => (typeof one === 'object' && 'turns' in one ? one.turns : one) !== 0);
}

/** An option that the chosen method or the option keepLengths does not support. */
export interface Conflict {
  option: RuledOption;
  other: 'method' | 'keepLengths';
}

export function conflicts(options: Ruled): Conflict[] {
  const keepsLengths = isUsed(options, 'keepLengths');
  return (Object.keys(RULES) as RuledOption[]).flatMap((option): Conflict[] => {
    if (!isUsed(options, option)) return [];
    if (!RULES[option].fitsMethod(options)) return [{ option, other: 'method' }];
    return keepsLengths && EXCLUDED_BY_KEPT_LENGTHS.includes(option) ? [{ option, other: 'keepLengths' }] : [];
  });
}

/** Sets options to their defaults. */
export function without<T extends Partial<Ruled>>(options: T, left: readonly RuledOption[]): T {
  const defaults = left.map((option) => [option, structuredClone(MOTION_DEFAULTS[option])]);
  return { ...options, ...(Object.fromEntries(defaults) as Partial<T>) };
}

/**
 * Applies the rules to options of which some are given in the same call and the others are inherited, from a project
 * or an earlier motion. An inherited option that conflicts is left out. The first conflict that remains is refused.
 */
export function settled<T extends Ruled>(
  options: T,
  isGiven: (option: RuledOption) => boolean,
): { options: T; left: (Conflict & { dropped: RuledOption })[]; refused: Conflict | null } {
  const left: (Conflict & { dropped: RuledOption })[] = [];
  let rest = options;
  for (const conflict of conflicts(options)) {
    const { option, other } = conflict;
    const dropped = !isGiven(option) ? option : other === 'keepLengths' && !isGiven(other) ? other : null;
    if (!dropped) continue;
    left.push({ ...conflict, dropped });
    rest = without(rest, [dropped]);
  }
  return { options: rest, left, refused: conflicts(rest)[0] ?? null };
}
