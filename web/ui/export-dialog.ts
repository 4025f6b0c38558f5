/** What to take along: an animation, one pose, a picture, a video, or the numbers; the size is stated before. */
import { EXPORT, USUAL_FRAMES } from '../engine/api/option-table.ts';
import { button, checkbox, numberField, segments } from './controls.ts';
import { h, memo, setField, setHidden, setText } from './dom.ts';
import { frameCount } from '../engine/api/whole-frames.ts';
import type { Range } from '../model/time-scale.ts';

export type ExportKind = 'animation' | 'pose' | 'picture' | 'numbers';
export type AnimationFormat = 'glb' | 'obj' | 'pc2' | 'mdd' | 'video';
/** Of a GLB: as few as the tolerance allows, one for each frame, or the keys with in-betweens that are mixed. */
export type Targets = 'few' | 'every' | 'principal';
export type Compression = 'none' | 'quantized' | 'meshopt';
export type PoseFormat = 'glb' | 'obj' | 'ply';
export type PictureFormat = 'png' | 'turntable';
export type VideoFormat = 'mp4' | 'webm';
export type NumbersFormat = 'measures' | 'patches';

/** What the dialog asks for; kept while the page is open, so that the next export starts from it. */
export interface ExportRequest {
  kind: ExportKind;
  animation: AnimationFormat;
  pose: PoseFormat;
  picture: PictureFormat;
  numbers: NumbersFormat;
  /** null = the first that the browser can write. */
  video: VideoFormat | null;
  targets: Targets;
  /** In percent of the diagonal. */
  tolerance: number;
  compression: Compression;
  /** null = the whole frames of the timeline, or 60 where it has none. */
  frames: number | null;
  /** First and last time; null = what plays. */
  range: [number, number] | null;
  /** Seconds; null = the length of the range. */
  duration: number | null;
  inPlace: boolean;
}

export const MAX_FRAMES = 2000;

export const DEFAULT_REQUEST: Readonly<ExportRequest> = {
  kind: 'animation',
  animation: 'glb',
  pose: 'glb',
  picture: 'png',
  numbers: 'measures',
  video: null,
  targets: 'few',
  tolerance: EXPORT.tolerance.default,
  compression: EXPORT.compression.default,
  frames: null,
  range: null,
  duration: null,
  inPlace: false,
};

export interface ExportDialogProps {
  request: ExportRequest;
  /** What the export will be, in words and size; null while it is being worked out. */
  plan: { text: string; warnings: readonly string[] } | null;
  /** What plays. */
  range: readonly [number, number];
  fps: number | null;
  /** What the browser can write; null while that is not known. */
  videoFormats: readonly VideoFormat[] | null;
}

export interface ExportDialogEvents {
  onChange(request: ExportRequest): void;
  onExport(request: ExportRequest): void;
}

const WORDS: Record<string, string> = {
  glb: 'Plays in Blender, three.js and most viewers, with the materials of the files. It is also the project: opened here again, it restores keys, times and options.',
  obj: 'One OBJ per frame in a zip, with the vertices, polygons and materials of your files in their order.',
  pc2: 'One OBJ and a point cache that moves its vertices, in a zip: exact in Mesh Cache of Blender and in Houdini.',
  mdd: 'One OBJ and a point cache that moves its vertices, in a zip: for Blender, Cinema 4D, LightWave and Maya.',
  video: 'A video of the current view, played once.',
  principal:
    'The keys as morph targets, and a few in-betweens that bend what those would shrink. With a table of the weights over one slider, and drivers for Blender.',
  'pose-glb': 'The current shape, with the materials of the files.',
  'pose-obj': 'The current shape.',
  'pose-ply': 'The current shape, binary.',
  png: 'A picture of the current view, without background.',
  turntable: 'A video of the current shape, turning once.',
  measures: 'A table of volume, area, bending energy and position in the shape plane over time.',
  patches: 'A table of the patch that each face belongs to.',
};

export function createExportDialog(events: ExportDialogEvents): {
  element: HTMLDialogElement;
  open(): void;
  close(): void;
  update(props: ExportDialogProps): void;
} {
  let request: ExportRequest = DEFAULT_REQUEST;
  let shown: ExportDialogProps | null = null;
  const change = (part: Partial<ExportRequest>): void => {
    request = { ...request, ...part };
    events.onChange(request);
  };
  const bounds = (): [number, number] => [...(request.range ?? shown?.range ?? [0, 1])] as [number, number];

  const kind = segments<ExportKind>(
    'What',
    'export-kind',
    [
      { value: 'animation', label: 'Animation' },
      { value: 'pose', label: 'Pose' },
      { value: 'picture', label: 'Picture' },
      { value: 'numbers', label: 'Numbers' },
    ],
    (value) => change({ kind: value }),
  );
  const animation = segments<AnimationFormat>(
    'Format',
    'export-animation',
    [
      { value: 'glb', label: 'GLB' },
      { value: 'obj', label: 'OBJ frames' },
      { value: 'pc2', label: 'PC2' },
      { value: 'mdd', label: 'MDD' },
      { value: 'video', label: 'Video' },
    ],
    (value) => change({ animation: value }),
  );
  const targets = segments<Targets>(
    'Morph targets',
    'export-targets',
    [
      { value: 'few', label: 'As few as needed' },
      { value: 'every', label: 'Every frame' },
      { value: 'principal', label: 'In-betweens' },
    ],
    (value) => change({ targets: value }),
  );
  const compression = segments<Compression>(
    'Numbers',
    'export-compression',
    [
      { value: 'none', label: 'Exact' },
      { value: 'quantized', label: '16 bits' },
      { value: 'meshopt', label: 'Meshopt' },
    ],
    (value) => change({ compression: value }),
  );
  const pose = segments<PoseFormat>(
    'Format',
    'export-pose',
    [
      { value: 'glb', label: 'GLB' },
      { value: 'obj', label: 'OBJ' },
      { value: 'ply', label: 'PLY' },
    ],
    (value) => change({ pose: value }),
  );
  const picture = segments<PictureFormat>(
    'Format',
    'export-picture',
    [
      { value: 'png', label: 'PNG' },
      { value: 'turntable', label: 'Turntable' },
    ],
    (value) => change({ picture: value }),
  );
  const numbers = segments<NumbersFormat>(
    'Format',
    'export-numbers',
    [
      { value: 'measures', label: 'Measures (CSV)' },
      { value: 'patches', label: 'Patches (CSV)' },
    ],
    (value) => change({ numbers: value }),
  );
  const video = segments<VideoFormat>(
    'Video format',
    'export-video',
    [
      { value: 'mp4', label: 'MP4' },
      { value: 'webm', label: 'WebM' },
    ],
    (value) => change({ video: value }),
  );

  const frames = numberField({
    label: 'Frames',
    testId: 'export-frames',
    min: 2,
    max: MAX_FRAMES,
    step: 1,
    onInput: (value) => change({ frames: Math.round(value) }),
  });
  const tolerance = numberField({
    label: 'Tolerance in percent of the diagonal',
    testId: 'export-tolerance',
    min: EXPORT.tolerance.least,
    max: EXPORT.tolerance.most,
    onInput: (value) => change({ tolerance: value }),
  });
  const from = numberField({
    label: 'From',
    testId: 'export-from',
    onInput: (value) => {
      const [, end] = bounds();
      if (value < end) change({ range: [value, end] });
    },
  });
  const to = numberField({
    label: 'To',
    testId: 'export-to',
    onInput: (value) => {
      const [start] = bounds();
      if (value > start) change({ range: [start, value] });
    },
  });
  const duration = numberField({
    label: 'Seconds',
    testId: 'export-duration',
    min: 0.01,
    max: 3600,
    onInput: (value) => change({ duration: value }),
  });
  const inPlace = checkbox('In place (without the overall translation)', 'export-in-place', (on) =>
    change({ inPlace: on }),
  );
  const row = (label: string, ...fields: Node[]): HTMLElement =>
    h('div', { class: 'field row' }, h('span', { class: 'label' }, label), ...fields);
  const framesRow = row('Frames', frames);
  const toleranceRow = row('Off by at most, % of the diagonal', tolerance);
  const rangeRow = row('From, to', from, to);
  const durationRow = row('Seconds', duration);
  const about = h('p', { class: 'hint' });
  const plan = h('p', { class: 'plan', 'data-testid': 'export-size', role: 'status' });
  const warnings = h('ul', { class: 'warning-list' });
  const go = button({
    label: 'Download',
    testId: 'export-go',
    icon: 'download',
    text: 'Download',
    kind: 'primary',
    onClick: () => {
      element.close();
      events.onExport(request);
    },
  });
  const element = h(
    'dialog',
    { class: 'dialog', 'data-testid': 'export-dialog', 'aria-label': 'Export' },
    h(
      'header',
      {},
      h('h2', {}, 'Export'),
      button({ label: 'Close', testId: 'export-close', icon: 'close', onClick: () => element.close() }),
    ),
    kind.element,
    animation.element,
    pose.element,
    picture.element,
    numbers.element,
    video.element,
    about,
    targets.element,
    toleranceRow,
    framesRow,
    rangeRow,
    durationRow,
    compression.element,
    inPlace.element,
    h('footer', {}, h('div', {}, plan, warnings), go),
  );
  element.addEventListener('click', (event) => {
    if (event.target === element) element.close();
  });

  const draw = memo((props: ExportDialogProps) => {
    request = props.request;
    shown = props;
    const { kind: what } = request;
    const isVideo = isVideoRequest(request);
    const files = what === 'animation' && !isVideo;
    kind.update(what);
    const formats = props.videoFormats ?? [];
    const noVideo = props.videoFormats?.length === 0 ? 'This browser cannot write videos.' : null;
    animation.update(request.animation, noVideo ? { video: noVideo } : {});
    pose.update(request.pose);
    picture.update(request.picture, noVideo ? { turntable: noVideo } : {});
    numbers.update(request.numbers);
    if (formats[0]) video.update(request.video ?? formats[0]);
    setHidden(animation.element, what !== 'animation');
    setHidden(pose.element, what !== 'pose');
    setHidden(picture.element, what !== 'picture');
    setHidden(numbers.element, what !== 'numbers');
    setHidden(video.element, !isVideo || formats.length < 2);
    const glb = files && request.animation === 'glb';
    targets.update(request.targets);
    compression.update(request.compression);
    setHidden(targets.element, !glb);
    setHidden(compression.element, !glb);
    setHidden(toleranceRow, !glb || request.targets === 'every');
    setHidden(framesRow, !files || (glb && request.targets !== 'every'));
    setHidden(rangeRow, what !== 'animation');
    setHidden(
      durationRow,
      !(what === 'animation' && request.animation !== 'obj' && request.animation !== 'pc2') &&
        !(what === 'picture' && request.picture === 'turntable'),
    );
    setHidden(inPlace.element, !files);
    inPlace.update(request.inPlace);
    setField(tolerance, String(request.tolerance));
    setText(about, WORDS[wordsFor(request)] ?? '');
    const [start, end] = bounds();
    setField(frames, String(framesWanted(request, [start, end], props.fps)));
    setField(from, String(Number(start.toFixed(4))));
    setField(to, String(Number(end.toFixed(4))));
    setField(duration, String(Number((request.duration ?? end - start).toFixed(3))));
    setText(plan, props.plan ? props.plan.text : 'Estimating the size');
    warnings.replaceChildren(...(props.plan?.warnings ?? []).map((warning) => h('li', {}, warning)));
  });
  return { element, open: () => element.showModal(), close: () => element.close(), update: draw };
}

/** An animation or a turn, as a video. */
export function isVideoRequest({ kind, animation, picture }: ExportRequest): boolean {
  return (kind === 'animation' && animation === 'video') || (kind === 'picture' && picture === 'turntable');
}

/** How many frames an animation gets. */
export function framesWanted({ frames }: ExportRequest, range: Range, fps: number | null): number {
  if (frames !== null) return frames;
  return fps === null ? USUAL_FRAMES : Math.max(frameCount(range, fps), 2);
}

function wordsFor({ kind, animation, pose, picture, numbers, targets }: ExportRequest): string {
  if (kind === 'animation' && animation === 'glb' && targets === 'principal') return 'principal';
  return { animation, pose: `pose-${pose}`, picture, numbers }[kind];
}
