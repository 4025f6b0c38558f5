/** Export options: an animation, one pose, an image, a video, or the numbers. The size is shown first. */
import { EXPORT } from '../engine/api/option-table.ts';
import type { KeysInfo } from '../engine/api/types.ts';
import type {
  AnimationFormat,
  Compression,
  ExportKind,
  ExportRequest,
  NumbersFormat,
  PictureFormat,
  Playing,
  PoseFormat,
  Targets,
  VideoFormat,
} from '../model/export-request.ts';
import { DEFAULT_REQUEST, isTurn, isVideoRequest } from '../model/export-request.ts';
import type { Choice } from './controls.ts';
import { button, checkbox, dialog, fieldRow, numberField, segments } from './controls.ts';
import { ownRate } from '../model/frames.ts';
import type { Source } from '../model/state.ts';
import type { Component, Fields } from './dom.ts';
import { h, memo, setField, setHidden, setText } from './dom.ts';
import type { Change, FieldsProps } from './export-fields.ts';
import { createPictureFields, createTimeFields } from './export-fields.ts';
import { exportName, safeName } from './export-name.ts';

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

export interface ExportDialogEvents {
  onChange(request: ExportRequest): void;
  onExport(request: ExportRequest): void;
  /** Opens the embed dialog. */
  onEmbed(): void;
}

const WORDS: Record<string, string> = {
  glb: 'Plays in Blender, three.js and most viewers, with the materials of the files. It is also the project: when reopened here, it restores keys, times and options.',
  obj: 'One OBJ per frame in a zip, with the vertices, polygons and materials of your files in their original order.',
  pc2: 'One OBJ and a point cache that moves its vertices, in a zip. Exact in Houdini and in Blender’s Mesh Cache modifier.',
  mdd: 'One OBJ and a point cache that moves its vertices, in a zip, for Blender, Cinema 4D, LightWave and Maya.',
  video:
    'A video of the current view. Every frame is drawn in the chosen size, even if this takes longer than playback.',
  principal:
    'The keys as morph targets, and a few in-betweens that prevent shrinking. Includes a table of the weights over one slider, and drivers for Blender.',
  'pose-glb': 'The current shape, with the materials of the files.',
  'pose-obj': 'The current shape.',
  'pose-ply': 'The current shape, binary.',
  png: 'An image of the current view.',
  turntable: 'A video of the current shape, turning once.',
  measures:
    'A table of volume, area, bending energy, sliding and position in the shape plane, with one row per frame. Includes bending by edge lengths and angles while its plot does.',
  patches: 'A table of the faces with their patches.',
};

const KINDS: readonly Choice<ExportKind>[] = [
  { value: 'animation', label: 'Animation' },
  { value: 'pose', label: 'Pose' },
  { value: 'picture', label: 'Picture' },
  { value: 'numbers', label: 'Numbers' },
];
const ANIMATION_FORMATS: readonly Choice<AnimationFormat>[] = [
  { value: 'glb', label: 'GLB' },
  { value: 'obj', label: 'OBJ frames' },
  { value: 'pc2', label: 'PC2' },
  { value: 'mdd', label: 'MDD' },
  { value: 'video', label: 'Video' },
];
const POSE_FORMATS: readonly Choice<PoseFormat>[] = [
  { value: 'glb', label: 'GLB' },
  { value: 'obj', label: 'OBJ' },
  { value: 'ply', label: 'PLY' },
];
const PICTURE_FORMATS: readonly Choice<PictureFormat>[] = [
  { value: 'png', label: 'PNG' },
  { value: 'turntable', label: 'Turntable' },
];
const NUMBERS_FORMATS: readonly Choice<NumbersFormat>[] = [
  { value: 'measures', label: 'Measures (CSV)' },
  { value: 'patches', label: 'Patches (CSV)' },
];
const VIDEO_FORMATS: readonly Choice<VideoFormat>[] = [
  { value: 'mp4', label: 'MP4' },
  { value: 'webm', label: 'WebM' },
  { value: 'gif', label: 'GIF' },
];

/** The options of each kind and format, and their visibility. */
function createFormatFields(change: Change): Fields<ExportDialogProps> {
  const kind = segments('What', 'export-kind', KINDS, (value) => change({ kind: value }));
  const animation = segments('Format', 'export-animation', ANIMATION_FORMATS, (value) => change({ animation: value }));
  const pose = segments('Format', 'export-pose', POSE_FORMATS, (value) => change({ pose: value }));
  const picture = segments('Format', 'export-picture', PICTURE_FORMATS, (value) => change({ picture: value }));
  const numbers = segments('Format', 'export-numbers', NUMBERS_FORMATS, (value) => change({ numbers: value }));
  const video = segments('Video format', 'export-video', VIDEO_FORMATS, (value) => change({ video: value }));
  return {
    elements: [kind, animation, pose, picture, numbers, video].map(({ element }) => element),
    update({ request, videoFormats }) {
      const { kind: what } = request;
      kind.update(what);
      animation.update(request.animation);
      pose.update(request.pose);
      picture.update(request.picture);
      numbers.update(request.numbers);
      const formats = videoFormats ?? [];
      if (formats[0]) video.update(request.video ?? formats[0], reasonsAgainst(formats));
      setHidden(animation.element, what !== 'animation');
      setHidden(pose.element, what !== 'pose');
      setHidden(picture.element, what !== 'picture');
      setHidden(numbers.element, what !== 'numbers');
      setHidden(video.element, !isVideoRequest(request) || formats.length === 0);
    },
  };
}

function reasonsAgainst(formats: readonly VideoFormat[]): Partial<Record<VideoFormat, string>> {
  const missing = VIDEO_FORMATS.filter(({ value }) => value !== 'gif' && !formats.includes(value));
  return Object.fromEntries(missing.map(({ value, label }) => [value, `This browser cannot write ${label}.`]));
}

/** Options of a GLB. */
function createGlbFields(change: Change) {
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
  const tolerance = numberField({
    label: 'Tolerance in percent of the model’s size',
    testId: 'export-tolerance',
    min: EXPORT.tolerance.min,
    max: EXPORT.tolerance.max,
    onInput: (value) => change({ tolerance: value }),
  });
  const toleranceRow = fieldRow('Tolerance, % of the model’s size', tolerance);
  return {
    before: [targets.element, toleranceRow],
    after: [compression.element],
    update({ request }: ExportDialogProps): void {
      const glb = request.kind === 'animation' && request.animation === 'glb';
      targets.update(request.targets);
      compression.update(request.compression);
      setField(tolerance, String(request.tolerance));
      setHidden(targets.element, !glb);
      setHidden(compression.element, !glb);
      setHidden(toleranceRow, !glb || request.targets === 'every');
    },
  };
}

export interface ExportDialog {
  element: HTMLDialogElement;
  open(): void;
  close(): void;
  update(props: ExportDialogProps): void;
}

export function createExportDialog(events: ExportDialogEvents): ExportDialog {
  let shown: ExportDialogProps | null = null;
  let request: ExportRequest = DEFAULT_REQUEST;
  // Shown immediately, because the next change may read the fields before the page is redrawn.
  const change: Change = (part) => {
    const next = { ...request, ...part };
    if (shown) update({ ...shown, request: next, plan: null });
    events.onChange(next);
  };
  const formats = createFormatFields(change);
  const glb = createGlbFields(change);
  const time = createTimeFields(change);
  const picture = createPictureFields(change);
  const inPlace = checkbox('Without travel (in place)', 'export-in-place', (on) => change({ inPlace: on }));
  const name = createName(change);
  const about = h('p', { class: 'hint' });
  const plan = createPlan();
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
  const embed = button({
    label: 'Embed this on your page',
    testId: 'export-embed',
    icon: 'link',
    text: 'Embed this on your page',
    onClick: () => {
      element.close();
      events.onEmbed();
    },
  });
  const element = dialog(
    { title: 'Export', label: 'Export', testId: 'export-dialog', closeId: 'export-close' },
    ...formats.elements,
    about,
    name.element,
    ...glb.before,
    ...time.elements,
    ...picture.elements,
    ...glb.after,
    inPlace.element,
    embed,
    h('footer', {}, plan.element, go),
  );

  const draw = memo((props: ExportDialogProps) => {
    request = props.request;
    const video = isVideoRequest(request) ? (request.video ?? props.videoFormats?.[0] ?? null) : null;
    const fields: FieldsProps = { ...props, own: props.info && ownRate(props.info), video };
    formats.update(props);
    name.update(props);
    glb.update(props);
    time.update(fields);
    picture.update(fields);
    setHidden(inPlace.element, request.kind !== 'animation' || request.animation === 'video');
    inPlace.update(request.inPlace);
    setHidden(embed, request.kind !== 'animation' || request.animation !== 'glb');
    setText(about, WORDS[wordsFor(request)] ?? '');
    plan.update(props);
  });
  const update = (props: ExportDialogProps): void => {
    shown = props;
    draw(props);
  };
  return { element, open: () => element.showModal(), close: () => element.close(), update };
}

/** Name of the file, and of the clip in a GLB. */
function createName(change: Change): Component<ExportDialogProps> {
  let usual = '';
  const field = h('input', {
    type: 'text',
    maxlength: 100,
    'data-testid': 'export-name',
    'aria-label': 'Name of the file, and of the animation in it',
    onchange() {
      const name = safeName(field.value.trim());
      // The field keeps the focus, and then `setField` does not change it.
      field.value = name || usual;
      change({ name: name === usual ? '' : name });
    },
  });
  return {
    element: fieldRow('Name', field),
    update({ request, source, info }) {
      usual = exportName(source, info);
      setField(field, request.name || usual);
    },
  };
}

function createPlan(): Component<ExportDialogProps> {
  const text = h('p', { class: 'plan', 'data-testid': 'export-size', role: 'status' });
  const warnings = h('ul', { class: 'warning-list' });
  return {
    element: h('div', {}, text, warnings),
    update({ plan }) {
      setText(text, plan ? plan.text : 'Estimating the size');
      warnings.replaceChildren(...(plan?.warnings ?? []).map((warning) => h('li', {}, warning)));
    },
  };
}

function wordsFor(request: ExportRequest): string {
  const { kind, animation, pose, picture, numbers, targets } = request;
  if (isTurn(request)) return 'turntable';
  if (kind === 'animation' && animation === 'glb' && targets === 'principal') return 'principal';
  return { animation, pose: `pose-${pose}`, picture, numbers }[kind];
}
