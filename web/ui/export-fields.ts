/** Rows of the export dialog: the settings of a request, each shown where it has an effect. */
import { EXPORT } from '../engine/api/option-table.ts';
import type { KeysInfo } from '../engine/api/types.ts';
import type { ExportNumbers, ExportRequest, Playing, SizeName, VideoFormat } from '../model/export-request.ts';
import {
  MAX_FRAMES,
  PIXELS,
  MAX_SECONDS,
  SIZES,
  canBounce,
  isTurn,
  isVideoRequest,
  sizeName,
} from '../model/export-request.ts';
import type { Source } from '../model/state.ts';
import { checkbox, fieldRow, numberField, resetButton, segments, select, setIdle, unit } from './controls.ts';
import type { Component, Part } from './dom.ts';
import { elementsOf, group, h, setField, setText, shownIf, withParts } from './dom.ts';

export interface ExportDialogProps extends Omit<Playing, 'own'> {
  request: ExportRequest;
  /** The open files, which give the default name and frame rate. */
  source: Source;
  info: KeysInfo | null;
  /** Description of the export with its size; null while it is computed. */
  plan: { text: string; warnings: readonly string[] } | null;
  /** Formats that the browser can write; null until known. */
  videoFormats: readonly VideoFormat[] | null;
}

export interface ExportRowProps extends ExportDialogProps {
  /** The format of a requested video. */
  video: VideoFormat | null;
  numbers: ExportNumbers;
}

type Row = Component<ExportRowProps>;
type IsShown = (props: ExportRowProps) => boolean;

/** Changes a part of the shown request; null: refuses the change. */
export type Change = (partOf: (shown: ExportRowProps) => Partial<ExportRequest> | null) => void;

export const isGlb: IsShown = ({ request }) => request.kind === 'animation' && request.animation === 'glb';
const isFiles: IsShown = ({ request }) => request.kind === 'animation' && request.animation !== 'video';
const isPicture: IsShown = ({ request }) => request.kind === 'picture' && !isTurn(request);
const isMeasures: IsShown = ({ request }) => request.kind === 'numbers' && request.numbers === 'measures';
const hasRange: IsShown = (props) => props.request.kind === 'animation' || isMeasures(props);
const isTimed: IsShown = (props) => hasRange(props) || isTurn(props.request);
const isThinned: IsShown = (props) => isGlb(props) && props.request.targets !== 'every';
const hasSize: IsShown = (props) => isPicture(props) || isVideoRequest(props.request);
const hasOwnSize: IsShown = (props) => hasSize(props) && sizeName(props.request, props.video) === 'own';

/** Choices of a request. */
const CHOICES = {
  kind: { animation: 'Animation', pose: 'Pose', picture: 'Picture', numbers: 'Numbers' },
  animation: { glb: 'GLB', obj: 'OBJ frames', pc2: 'PC2', mdd: 'MDD', video: 'Video' },
  pose: { glb: 'GLB', obj: 'OBJ', ply: 'PLY' },
  picture: { png: 'PNG', turntable: 'Turntable' },
  numbers: { measures: 'Measures (CSV)', patches: 'Patches (CSV)' },
  video: { mp4: 'MP4', webm: 'WebM', gif: 'GIF' },
  targets: { few: 'As few as needed', every: 'Every frame', principal: 'In-betweens' },
  compression: { none: 'Exact', quantized: '16 bits', meshopt: 'Meshopt' },
} as const satisfies { [N in keyof ExportRequest]?: Record<NonNullable<ExportRequest[N]> & string, string> };

function createChoice(name: keyof typeof CHOICES, label: string, change: Change): Row {
  const choices = Object.entries(CHOICES[name]).map(([value, text]) => ({ value, label: text }));
  const row = segments(label, `export-${name}`, choices, (value) => change(() => ({ [name]: value })));
  return {
    element: row.element,
    update({ request, videoFormats }) {
      row.update(request[name] ?? videoFormats?.[0] ?? '', name === 'video' ? reasonsAgainst(videoFormats ?? []) : {});
    },
  };
}

function reasonsAgainst(formats: readonly VideoFormat[]): Record<string, string> {
  const missing = Object.entries(CHOICES.video).filter(
    ([format]) => format !== 'gif' && !formats.includes(format as VideoFormat),
  );
  return Object.fromEntries(missing.map(([format, label]) => [format, `This browser cannot write ${label}.`]));
}

interface NumberWords {
  label: string;
  bounds?: { min: number; max: number; step?: number };
  /** Number of decimals; default: 4. */
  digits?: number;
  read(shown: ExportRowProps): number;
  change(value: number, shown: ExportRowProps): Partial<ExportRequest> | null;
}

/** Numbers of a request. */
const NUMBERS = {
  tolerance: {
    label: 'Tolerance in percent of the model’s size',
    bounds: EXPORT.tolerance,
    read: ({ request }) => request.tolerance,
    change: (tolerance) => ({ tolerance }),
  },
  from: {
    label: 'Start, in seconds on the timeline',
    read: ({ numbers }) => numbers.range[0],
    change: (
      start,
      {
        numbers: {
          range: [, end],
        },
      },
    ) => (start < end ? { range: [start, end] } : null),
  },
  to: {
    label: 'End, in seconds on the timeline',
    read: ({ numbers }) => numbers.range[1],
    change: (
      end,
      {
        numbers: {
          range: [start],
        },
      },
    ) => (end > start ? { range: [start, end] } : null),
  },
  duration: {
    label: 'Seconds',
    bounds: { min: 0.01, max: MAX_SECONDS },
    digits: 3,
    read: ({ numbers }) => numbers.seconds,
    change: (value, { request }) => (isTurn(request) ? { turn: value } : { duration: value }),
  },
  frames: {
    label: 'Frames',
    bounds: { min: EXPORT.frames.min, max: MAX_FRAMES, step: 1 },
    read: ({ numbers }) => numbers.frames,
    change: (frames) => ({ frames, rate: null }),
  },
  rate: {
    label: 'Frames per second',
    bounds: EXPORT.fps,
    digits: 3,
    read: ({ numbers }) => numbers.rate,
    change: (rate) => ({ rate, frames: null }),
  },
  width: {
    label: 'Width in pixels',
    bounds: PIXELS,
    read: ({ request }) => request.own.width,
    change: (width, { request: { own } }) => ({ own: { ...own, width } }),
  },
  height: {
    label: 'Height in pixels',
    bounds: PIXELS,
    read: ({ request }) => request.own.height,
    change: (height, { request: { own } }) => ({ own: { ...own, height } }),
  },
} as const satisfies Record<string, NumberWords>;

function createNumber(name: keyof typeof NUMBERS, change: Change): Row {
  const { label, bounds, digits = 4, read, change: partOf }: NumberWords = NUMBERS[name];
  const onInput = (value: number): void => change((shown) => partOf(value, shown));
  const element = numberField({ ...bounds, label, testId: `export-${name}`, onInput });
  return {
    element,
    update(props) {
      setField(element, String(Number(read(props).toFixed(digits))));
      // For a video, the duration determines the number of frames.
      element.readOnly = name === 'frames' && isVideoRequest(props.request);
    },
  };
}

/** What is exported, and its format. */
export function createFormats(change: Change): Row[] {
  const choice = (name: keyof typeof CHOICES, label: string): Row => createChoice(name, label, change);
  return [
    choice('kind', 'What'),
    ...(['animation', 'pose', 'picture', 'numbers'] as const).map((kind) =>
      shownIf<ExportRowProps>(({ request }) => request.kind === kind, choice(kind, 'Format')),
    ),
    shownIf(({ video, videoFormats }) => video !== null && !!videoFormats?.length, choice('video', 'Video format')),
  ];
}

export function createSettings(change: Change): Row[] {
  const number = (name: keyof typeof NUMBERS): Row => createNumber(name, change);
  const row = (label: string, ...parts: Part<ExportRowProps>[]): Row =>
    withParts(fieldRow(label, ...elementsOf(parts)), parts);
  const check = (name: 'bounce' | 'inPlace' | 'transparent' | 'crop', testId: string, label: string): Row => {
    const { element, update } = checkbox(label, `export-${testId}`, (on) => change(() => ({ [name]: on })));
    return { element, update: ({ request }) => update(request[name]) };
  };
  const frames = row('Frames', number('frames'), unit('at'), number('rate'), unit('fps'));
  const bounce = check('bounce', 'bounce', 'Forwards, then backwards (twice as long)');
  const transparent = check('transparent', 'transparent', 'Transparent, without the floor');
  const crop = check('crop', 'crop', 'Cropped to the shape');
  return [
    shownIf(isGlb, createChoice('targets', 'Morph targets', change)),
    shownIf(isThinned, row('Tolerance, % of the model’s size', number('tolerance'))),
    shownIf(hasRange, row('Range', number('from'), unit('to'), number('to'), unit('s'))),
    shownIf(isTimed, row('Seconds', createSpeed(), createReset(change), number('duration'))),
    shownIf((props) => isTimed(props) && !isThinned(props), frames),
    shownIf(({ request }) => canBounce(request), bounce),
    shownIf(hasSize, createSize(change)),
    shownIf(hasOwnSize, row('Pixels', number('width'), unit('×'), number('height'))),
    group([transparent, crop], isPicture, 'checks'),
    shownIf(isGlb, createChoice('compression', 'Numbers', change)),
    shownIf(isFiles, check('inPlace', 'in-place', 'Without travel (in place)')),
  ];
}

function createReset(change: Change): Row {
  const label = 'Reset to the playback duration';
  const element = resetButton(label, 'export-duration-reset', () => change(() => ({ duration: null })));
  return { element, update: ({ request }) => setIdle(element, isTurn(request) || request.duration === null) };
}

function createSpeed(): Row {
  const element = h('span', { class: 'unit', 'data-testid': 'export-speed' });
  return {
    element,
    update: ({ request, numbers }) => setText(element, isTurn(request) ? '' : speedWords(request, numbers.speed)),
  };
}

function createSize(change: Change): Row {
  const sizes = (Object.keys(SIZE_WORDS) as SizeName[]).map((value) => ({ value, label: sizeLabel(value) }));
  const { element, update } = select('Size', 'export-pixels', sizes, (value) =>
    change(({ request }) => (isVideoRequest(request) ? { videoSize: value } : { size: value })),
  );
  element.classList.add('row');
  return { element, update: ({ request, video }) => update(sizeName(request, video)) };
}

function speedWords({ duration }: ExportRequest, speed: number): string {
  const times = `${Number(speed.toPrecision(3))}×`;
  if (duration !== null) return `${times} the timeline`;
  return speed === 1 ? 'as played here' : `as played at ${times}`;
}

const SIZE_WORDS: Record<SizeName, string> = {
  window: 'As on the screen',
  small: 'Small',
  '720p': '720p',
  '1080p': '1080p',
  '1440p': '1440p',
  '4k': '4K',
  square: 'Square',
  upright: 'Upright',
  own: 'Own size',
};

function sizeLabel(name: SizeName): string {
  if (name === 'window' || name === 'own') return SIZE_WORDS[name];
  const { width, height } = SIZES[name];
  return `${SIZE_WORDS[name]}, ${width} × ${height}`;
}
