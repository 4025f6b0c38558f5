/** Rows of the export dialog: duration, number of frames, and image size. */
import type { ExportNumbers, ExportRequest, Playing, SizeName, VideoFormat } from '../model/export-request.ts';
import {
  MIN_PIXELS,
  MAX_FRAMES,
  MAX_PIXELS,
  MAX_SECONDS,
  SIZES,
  canBounce,
  goesBack,
  exportNumbers,
  isTurn,
  isVideoRequest,
  sizeName,
} from '../model/export-request.ts';
import { checkbox, fieldRow, numberField, resetButton, select, setIdle, unit } from './controls.ts';
import type { Fields } from './dom.ts';
import { h, setField, setHidden, setText } from './dom.ts';

export type Change = (part: Partial<ExportRequest>) => void;

export interface FieldsProps extends Playing {
  request: ExportRequest;
  /** The format of a requested video. */
  video: VideoFormat | null;
}

const shortest = (value: number, digits: number): string => String(Number(value.toFixed(digits)));

/** First and last time, duration, and number of frames. */
export function createTimeFields(change: Change): Fields<FieldsProps> {
  let numbers: ExportNumbers | null = null;
  let turns = false;
  const from = numberField({
    label: 'Start, in seconds on the timeline',
    testId: 'export-from',
    onInput: (value) => {
      if (numbers && value < numbers.range[1]) change({ range: [value, numbers.range[1]] });
    },
  });
  const to = numberField({
    label: 'End, in seconds on the timeline',
    testId: 'export-to',
    onInput: (value) => {
      if (numbers && value > numbers.range[0]) change({ range: [numbers.range[0], value] });
    },
  });
  const seconds = numberField({
    label: 'Seconds',
    testId: 'export-duration',
    min: 0.01,
    max: MAX_SECONDS,
    onInput: (value) => change(turns ? { turn: value } : { duration: value }),
  });
  const reset = resetButton('Reset to the playback duration', 'export-duration-reset', () =>
    change({ duration: null }),
  );
  const speed = h('span', { class: 'unit', 'data-testid': 'export-speed' });
  const frames = numberField({
    label: 'Frames',
    testId: 'export-frames',
    min: 2,
    max: MAX_FRAMES,
    step: 1,
    onInput: (value) => change({ frames: value, rate: null }),
  });
  const rate = numberField({
    label: 'Frames per second',
    testId: 'export-rate',
    min: 0.01,
    max: 1000,
    onInput: (value) => change({ rate: value, frames: null }),
  });
  const bounce = checkbox('Forwards, then backwards (twice as long)', 'export-bounce', (on) => change({ bounce: on }));
  const rangeRow = fieldRow('Range', from, unit('to'), to, unit('s'));
  const secondsRow = fieldRow('Seconds', speed, reset, seconds);
  const framesRow = fieldRow('Frames', frames, unit('at'), rate, unit('fps'));
  return {
    elements: [rangeRow, secondsRow, framesRow, bounce.element],
    update({ request, video, ...playing }) {
      const { kind, animation, targets } = request;
      const isVideo = isVideoRequest(request);
      const measures = kind === 'numbers' && request.numbers === 'measures';
      const thinned = animation === 'glb' && targets !== 'every';
      turns = isTurn(request);
      numbers = exportNumbers(request, playing, video);
      setHidden(rangeRow, kind !== 'animation' && !measures);
      setHidden(secondsRow, kind !== 'animation' && !measures && !turns);
      setHidden(framesRow, !(kind === 'animation' && !thinned) && !turns && !measures);
      setHidden(bounce.element, !canBounce(request));
      setField(from, shortest(numbers.range[0], 4));
      setField(to, shortest(numbers.range[1], 4));
      setField(seconds, shortest(numbers.seconds, 3));
      setText(speed, turns ? '' : speedWords(request, numbers.speed));
      setIdle(reset, turns || request.duration === null);
      setField(frames, String(numbers.frames));
      // For a video, the duration determines the number of frames.
      frames.readOnly = isVideo;
      setField(rate, shortest(numbers.rate, 3));
      bounce.update(goesBack(request));
    },
  };
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

/** Size, and for a PNG the background. */
export function createPictureFields(change: Change): Fields<FieldsProps> {
  let request: ExportRequest | null = null;
  const size = select<SizeName>(
    'Size',
    'export-pixels',
    (Object.keys(SIZE_WORDS) as SizeName[]).map((value) => ({ value, label: sizeLabel(value) })),
    (value) => change(request && isVideoRequest(request) ? { videoSize: value } : { size: value }),
  );
  const side = (name: 'width' | 'height'): HTMLInputElement =>
    numberField({
      label: `${name === 'width' ? 'Width' : 'Height'} in pixels`,
      testId: `export-${name}`,
      min: MIN_PIXELS,
      max: MAX_PIXELS,
      step: 1,
      onInput: (value) => {
        if (request) change({ own: { ...request.own, [name]: value } });
      },
    });
  const [width, height] = [side('width'), side('height')];
  const transparent = checkbox('Transparent, without the floor', 'export-transparent', (on) =>
    change({ transparent: on }),
  );
  const crop = checkbox('Cropped to the shape', 'export-crop', (on) => change({ crop: on }));
  const ownRow = fieldRow('Pixels', width, unit('×'), height);
  const checks = h('div', { class: 'checks' }, transparent.element, crop.element);
  size.element.classList.add('row');
  return {
    elements: [size.element, ownRow, checks],
    update(props) {
      ({ request } = props);
      const isVideo = isVideoRequest(request);
      const isPicture = request.kind === 'picture' && !isVideo;
      const name = sizeName(request, props.video);
      size.update(name);
      setHidden(size.element, !isVideo && !isPicture);
      setHidden(ownRow, name !== 'own' || (!isVideo && !isPicture));
      setHidden(checks, !isPicture);
      setField(width, String(request.own.width));
      setField(height, String(request.own.height));
      transparent.update(request.transparent);
      crop.update(request.crop);
    },
  };
}

function sizeLabel(name: SizeName): string {
  if (name === 'window' || name === 'own') return SIZE_WORDS[name];
  const { width, height } = SIZES[name];
  return `${SIZE_WORDS[name]}, ${width} × ${height}`;
}
