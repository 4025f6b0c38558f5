/**
 * Every attribute and property of <shape-spline>, described once. Observed attributes, typed properties,
 * custom-elements.json and the documentation are derived from this table. Engine options have their command-line names.
 */
import { ENCODING, IMPORT, MOTION, PER_KEY, optionsIn } from '../engine/api/option-table.ts';
import type { Option, OptionTable, ValueOf } from '../engine/api/option-table.ts';
import { orbitOf, targetOf } from '../model/camera-words.ts';
import { GHOST_FACES } from '../model/state.ts';

/** What a change affects. `source` imports again, `motion` fits again, and the others only update what is shown. */
export type Concern = 'source' | 'motion' | 'look' | 'camera' | 'play' | 'page';

interface Described {
  concern: Concern;
  doc: string;
}
export interface TextRow extends Described {
  kind: 'text';
  default: string;
  /** Parses the text; null if invalid. */
  reads?: (words: string) => unknown;
  sample?: string;
}
export interface FlagRow extends Described {
  kind: 'flag';
  default: boolean;
}
export interface NumberRow extends Described {
  kind: 'number';
  default: number | null;
  min?: number;
  above?: number;
  max: number;
  whole?: boolean;
}
export interface ChoiceRow extends Described {
  kind: 'choice';
  choices: readonly string[];
  /** Value without the attribute. */
  default: string;
  /** Value of an empty attribute. */
  empty?: string;
}
/** Numbers separated by spaces, commas or colons; null if there are none. */
export interface NumbersRow extends Described {
  kind: 'numbers';
  default: null;
  /** Required number of entries. */
  count?: number;
}
export interface WordsRow extends Described {
  kind: 'words';
  choices: readonly string[];
  default: readonly string[];
}
export type Row = TextRow | FlagRow | NumberRow | ChoiceRow | NumbersRow | WordsRow;

const OWN = {
  src: {
    kind: 'text',
    default: '',
    concern: 'source',
    doc:
      'URLs of the keys, separated by spaces: several files with one pose each, or one file with morph targets, an ' +
      'animation or a project exported by shapespline. Children `<source src time>` are an alternative. The property `keys` ' +
      '(URLs, Blobs, ArrayBuffers) overrides both.',
  },
  autoplay: {
    kind: 'flag',
    default: false,
    concern: 'play',
    doc: 'Starts playing once loaded and visible, unless the user prefers reduced motion.',
  },
  loop: {
    kind: 'choice',
    choices: ['loop', 'bounce'],
    default: '',
    empty: 'loop',
    concern: 'play',
    doc: 'At the end, starts again (`loop`, or no value) or plays back and forth (`bounce`).',
  },
  controls: {
    kind: 'flag',
    default: false,
    concern: 'page',
    doc: 'Shows a play button and a timeline with the keys.',
  },
  playbackRate: {
    kind: 'number',
    default: 1,
    above: 0,
    max: 100,
    concern: 'play',
    doc: 'Playback speed relative to the key times.',
  },
  currentTime: {
    kind: 'number',
    default: 0,
    min: -1e9,
    max: 1e9,
    concern: 'play',
    doc:
      'Current time, in seconds on the scale of the key times. It can be beyond the keys. The attribute sets the initial ' +
      'time; the property is the current time. Setting the property to a non-finite number throws a TypeError; null or ' +
      'undefined removes the attribute.',
  },
  range: {
    kind: 'numbers',
    default: null,
    count: 2,
    concern: 'play',
    doc: 'First and last time to play, which can be beyond the keys. Default: the first and the last key.',
  },
  loading: {
    kind: 'choice',
    choices: ['lazy', 'eager'],
    default: 'lazy',
    concern: 'page',
    doc: 'Fetches nothing until the element comes near the view (`lazy`), or fetches at once (`eager`).',
  },
  reveal: {
    kind: 'choice',
    choices: ['auto', 'manual'],
    default: 'auto',
    concern: 'page',
    doc: 'Removes the poster when the shape is ready (`auto`), or only when `dismissPoster()` is called (`manual`).',
  },
  poster: { kind: 'text', default: '', concern: 'page', doc: 'URL of an image to show before the shape.' },
  alt: { kind: 'text', default: '', concern: 'page', doc: 'Text alternative for screen readers.' },
  cameraControls: {
    kind: 'flag',
    default: false,
    concern: 'page',
    doc: 'Lets users rotate the shape with mouse, finger and keyboard. With `controls`, on unless set to "false".',
  },
  cameraOrbit: {
    kind: 'text',
    default: '',
    reads: orbitOf,
    sample: '30deg 75deg 105%',
    concern: 'camera',
    doc: 'Camera position as azimuth, polar angle and distance, such as `30deg 75deg 105%`. Each can be `auto`.',
  },
  cameraTarget: {
    kind: 'text',
    default: '',
    reads: targetOf,
    sample: '0m 1m 0m',
    concern: 'camera',
    doc: 'Point that the camera looks at, such as `0m 1m 0m`; `auto` is the centre of the shape.',
  },
  colour: {
    kind: 'choice',
    choices: ['texture', 'phase', 'patches'],
    default: 'texture',
    concern: 'look',
    doc:
      "Colours of the shape. `texture`: the file's own materials, or clay if it has none. `phase`: one colour at a key, " +
      'another between keys, a third beyond them. `patches`: one colour per patch, the regions that the method rotates ' +
      'as a whole.',
  },
  color: {
    kind: 'choice',
    choices: ['texture', 'phase', 'patches'],
    default: 'texture',
    concern: 'look',
    doc: 'American spelling of `colour`, which takes precedence.',
  },
  compare: {
    kind: 'words',
    choices: MOTION.method.choices,
    default: [],
    concern: 'motion',
    doc: 'Methods to show next to `method`, separated by spaces. Options that one of them lacks are left out for it.',
  },
  ghost: {
    kind: 'flag',
    default: false,
    concern: 'motion',
    doc: `Computes the motion on a simplified mesh, with ${GHOST_FACES} faces unless \`ghost-faces\` is given.`,
  },
} as const satisfies Readonly<Record<string, Row>>;

/** Import options that have attributes. A change imports again. */
const IMPORTED = pick(IMPORT, ['animation', 'sample', 'up', 'unit']);
/** Import options that the motion takes as well, so a change does not import again. */
const TIMED = pick(IMPORT, ['keyTimes']);
/** Motion options that have attributes. Pins have none: they come from a project's file. */
const MOVED = pick(MOTION, [
  'method',
  'hold',
  'boundary',
  'startSpeed',
  'endSpeed',
  'period',
  'keepLengths',
  'inPlace',
]);
const SHAPED = pick(PER_KEY, ['tension', 'bias', 'earlier', 'swing']);
const ENCODED = pick(ENCODING, ['stretch', 'patches', 'ghostFaces', 'transfer', 'placement', 'precision']);
const ENGINE = { ...IMPORTED, ...TIMED, ...MOVED, ...SHAPED, ...ENCODED };

type OwnValue<R> = R extends { kind: 'flag' }
  ? boolean
  : R extends { kind: 'numbers'; count: 2 }
    ? [number, number] | null
    : R extends { kind: 'number' }
      ? number
      : R extends { kind: 'words'; choices: readonly (infer C)[] }
        ? C[]
        : R extends { choices: readonly (infer C)[]; default: infer D }
          ? C | D
          : string;

type EngineValue<O> = O extends { kind: 'numbers' | 'sample' }
  ? number[] | null
  : O extends { kind: 'animation' }
    ? string
    : ValueOf<O>;

/** Properties of the element that are also attributes. */
export type ShapeSplineProperties = { -readonly [N in keyof typeof OWN]: OwnValue<(typeof OWN)[N]> } & {
  -readonly [N in keyof typeof ENGINE as N extends keyof typeof SHAPED ? never : N]: EngineValue<(typeof ENGINE)[N]>;
} & { [N in keyof typeof SHAPED]: number[] | null };

export type PropertyName = keyof ShapeSplineProperties;

/** The table's rows by property. */
export const ROWS: Readonly<Record<PropertyName, Row>> = {
  ...OWN,
  ...Object.fromEntries(optionsIn(ENGINE).map(([name, option]) => [name, rowOf(name, option)])),
} as unknown as Record<PropertyName, Row>;

export const PROPERTIES = Object.keys(ROWS) as PropertyName[];

/** HTML attribute names have no capital letters. */
export function attributeOf(property: PropertyName): string {
  return property.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

const BY_ATTRIBUTE = new Map(PROPERTIES.map((property) => [attributeOf(property), property]));
export const ATTRIBUTES: readonly string[] = [...BY_ATTRIBUTE.keys()];

export function propertyOf(attribute: string): PropertyName | undefined {
  return BY_ATTRIBUTE.get(attribute);
}

/** The engine call that has this property as an option; null for none. */
export function engineCallOf(property: PropertyName): 'import' | 'sequence' | null {
  if (property in IMPORTED) return 'import';
  return property in ENGINE && !(property in TIMED) ? 'sequence' : null;
}

function rowOf(name: string, option: Option): Row {
  const described: Described = { concern: name in IMPORTED ? 'source' : 'motion', doc: sentence(option.help) };
  if (option.kind === 'choice')
    return { ...described, kind: 'choice', choices: option.choices, default: option.default ?? option.choices[0]! };
  if (option.kind === 'flag') return { ...described, kind: 'flag', default: option.default === true };
  if (option.kind === 'animation') return { ...described, kind: 'text', default: '' };
  if (option.kind !== 'number' || name in SHAPED) return { ...described, kind: 'numbers', default: null };
  const { above, max, default: usual = null, zero, whole = false } = option;
  // The value 0 here corresponds to "off" on the command line.
  const min = zero === undefined ? option.min : 0;
  return { ...described, kind: 'number', default: usual, above, min, max, whole };
}

function sentence(words: string): string {
  return `${words[0]!.toUpperCase()}${words.slice(1)}.`;
}

function pick<T extends OptionTable, N extends keyof T>(table: T, names: readonly N[]): Pick<T, N> {
  return Object.fromEntries(names.map((name) => [name, table[name]])) as Pick<T, N>;
}
