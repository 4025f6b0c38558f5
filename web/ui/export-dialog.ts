/** Export options: an animation, one pose, an image, a video, or the numbers. The size is shown first. */
import { EXPORT } from '../engine/api/option-table.ts';
import type { KeysInfo } from '../engine/api/types.ts';
import type { ExportRequest, Playing, VideoFormat } from '../model/export-request.ts';
import { DEFAULT_REQUEST, isTurn, isVideoRequest } from '../model/export-request.ts';
import { button, checkbox, dialog, fieldRow, numberRow, segments } from './controls.ts';
import { ownRate } from '../model/frames.ts';
import type { Source } from '../model/state.ts';
import type { Component } from './dom.ts';
import { elementsOf, h, memo, setField, setHidden, setText, updateAll } from './dom.ts';
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

const isGlb = ({ request }: ExportDialogProps): boolean => request.kind === 'animation' && request.animation === 'glb';

/** Choices of a request, and when they are shown. */
const CHOICES = {
  kind: {
    label: 'What',
    choices: { animation: 'Animation', pose: 'Pose', picture: 'Picture', numbers: 'Numbers' },
    isShown: () => true,
  },
  animation: {
    label: 'Format',
    choices: { glb: 'GLB', obj: 'OBJ frames', pc2: 'PC2', mdd: 'MDD', video: 'Video' },
    isShown: ({ request }) => request.kind === 'animation',
  },
  pose: {
    label: 'Format',
    choices: { glb: 'GLB', obj: 'OBJ', ply: 'PLY' },
    isShown: ({ request }) => request.kind === 'pose',
  },
  picture: {
    label: 'Format',
    choices: { png: 'PNG', turntable: 'Turntable' },
    isShown: ({ request }) => request.kind === 'picture',
  },
  numbers: {
    label: 'Format',
    choices: { measures: 'Measures (CSV)', patches: 'Patches (CSV)' },
    isShown: ({ request }) => request.kind === 'numbers',
  },
  video: {
    label: 'Video format',
    choices: { mp4: 'MP4', webm: 'WebM', gif: 'GIF' },
    isShown: ({ request, videoFormats }) => isVideoRequest(request) && !!videoFormats?.length,
  },
  targets: {
    label: 'Morph targets',
    choices: { few: 'As few as needed', every: 'Every frame', principal: 'In-betweens' },
    isShown: isGlb,
  },
  compression: {
    label: 'Numbers',
    choices: { none: 'Exact', quantized: '16 bits', meshopt: 'Meshopt' },
    isShown: isGlb,
  },
} as const satisfies Partial<Record<keyof ExportRequest, ChoiceRow>>;

interface ChoiceRow {
  label: string;
  choices: Readonly<Record<string, string>>;
  isShown(props: ExportDialogProps): boolean;
}

function createChoice(name: keyof typeof CHOICES, change: Change): Component<ExportDialogProps> {
  const { label, choices, isShown }: ChoiceRow = CHOICES[name];
  const words = Object.entries(choices).map(([value, text]) => ({ value, label: text }));
  const { element, update } = segments(label, `export-${name}`, words, (value) => change({ [name]: value }));
  return {
    element,
    update(props) {
      const { request, videoFormats } = props;
      update(request[name] ?? videoFormats?.[0] ?? '', name === 'video' ? reasonsAgainst(videoFormats ?? []) : {});
      setHidden(element, !isShown(props));
    },
  };
}

function reasonsAgainst(formats: readonly VideoFormat[]): Record<string, string> {
  const missing = Object.entries(CHOICES.video.choices).filter(
    ([format]) => format !== 'gif' && !formats.includes(format as VideoFormat),
  );
  return Object.fromEntries(missing.map(([format, label]) => [format, `This browser cannot write ${label}.`]));
}

function createTolerance(change: Change): Component<ExportDialogProps> {
  const { element, update } = numberRow({
    label: 'Tolerance, % of the model’s size',
    name: 'Tolerance in percent of the model’s size',
    testId: 'export-tolerance',
    min: EXPORT.tolerance.min,
    max: EXPORT.tolerance.max,
    onInput: (tolerance) => change({ tolerance: tolerance ?? 0 }),
  });
  return {
    element,
    update(props) {
      update(props.request.tolerance);
      setHidden(element, !isGlb(props) || props.request.targets === 'every');
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
  const choices = (names: readonly (keyof typeof CHOICES)[]): Component<ExportDialogProps>[] =>
    names.map((choice) => createChoice(choice, change));
  const formats = choices(['kind', 'animation', 'pose', 'picture', 'numbers', 'video']);
  const targets = [...choices(['targets']), createTolerance(change)];
  const compression = choices(['compression']);
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
    ...elementsOf(formats),
    about,
    name.element,
    ...elementsOf(targets),
    ...time.elements,
    ...picture.elements,
    ...elementsOf(compression),
    inPlace.element,
    embed,
    h('footer', {}, plan.element, go),
  );

  const draw = memo((props: ExportDialogProps) => {
    request = props.request;
    const video = isVideoRequest(request) ? (request.video ?? props.videoFormats?.[0] ?? null) : null;
    const fields: FieldsProps = { ...props, own: props.info && ownRate(props.info), video };
    updateAll([...formats, name, ...targets, ...compression, plan], props);
    time.update(fields);
    picture.update(fields);
    setHidden(inPlace.element, request.kind !== 'animation' || request.animation === 'video');
    inPlace.update(request.inPlace);
    setHidden(embed, request.kind !== 'animation' || request.animation !== 'glb');
    setText(about, WORDS[wordsFor(request)] ?? '');
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
