/** Export options: an animation, one pose, an image, a video, or the numbers. The size is shown first. */
import type { ExportRequest } from '../model/export-request.ts';
import { exportNumbers, isTurn, isVideoRequest } from '../model/export-request.ts';
import { ownRate } from '../model/frames.ts';
import { button, dialog, fieldRow } from './controls.ts';
import type { Component } from './dom.ts';
import { elementsOf, h, memo, setField, setText, shownIf, updateAll } from './dom.ts';
import type { Change, ExportDialogProps, ExportRowProps } from './export-fields.ts';
import { createFormats, createSettings, isGlb } from './export-fields.ts';
import { exportName, safeName } from './export-name.ts';

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

export interface ExportDialog {
  element: HTMLDialogElement;
  open(): void;
  close(): void;
  update(props: ExportDialogProps): void;
}

export function createExportDialog(events: ExportDialogEvents): ExportDialog {
  let shown: ExportRowProps | null = null;
  // Shown immediately, because the next change may read the fields before the page is redrawn.
  const change: Change = (partOf) => {
    const part = shown && partOf(shown);
    if (!shown || !part) return;
    const request = { ...shown.request, ...part };
    update({ ...shown, request, plan: null });
    events.onChange(request);
  };
  const closeAnd = (act: (request: ExportRequest) => void) => () => {
    element.close();
    if (shown) act(shown.request);
  };
  const about = h('p', { class: 'hint' });
  const plan = createPlan();
  const go = button({
    label: 'Download',
    testId: 'export-go',
    icon: 'download',
    text: 'Download',
    kind: 'primary',
    onClick: closeAnd(events.onExport),
  });
  const embed = button({
    label: 'Embed this on your page',
    testId: 'export-embed',
    icon: 'link',
    text: 'Embed this on your page',
    onClick: closeAnd(events.onEmbed),
  });
  const rows: Component<ExportRowProps>[] = [
    ...createFormats(change),
    { element: about, update: ({ request }) => setText(about, WORDS[wordsFor(request)] ?? '') },
    createName(change),
    ...createSettings(change),
    shownIf(isGlb, embed),
  ];
  const element = dialog(
    { title: 'Export', label: 'Export', testId: 'export-dialog', closeId: 'export-close' },
    ...elementsOf(rows),
    h('footer', {}, plan.element, go),
  );
  const update = memo((props: ExportDialogProps) => {
    const { request, videoFormats, info } = props;
    const video = isVideoRequest(request) ? (request.video ?? videoFormats?.[0] ?? null) : null;
    const numbers = exportNumbers(request, { ...props, own: info && ownRate(info) }, video);
    shown = { ...props, video, numbers };
    updateAll([...rows, plan], shown);
  });
  return { element, open: () => element.showModal(), close: () => element.close(), update };
}

/** Name of the file, and of the clip in a GLB. */
function createName(change: Change): Component<ExportRowProps> {
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
      change(() => ({ name: name === usual ? '' : name }));
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

function createPlan(): Component<ExportRowProps> {
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
