/** Encoding of the shape: stretches, reference, patches, and the import report. */
import type { KeysInfo, SequenceStats, Stretch } from '../engine/api/types.ts';
import type { Orientation } from '../model/orientation.ts';
import type { Encoding, KeyRef } from '../model/state.ts';
import { DEFAULT_ENCODING } from '../model/state.ts';
import { keyLabel } from '../model/key-names.ts';
import type { Choice } from './controls.ts';
import { button, fieldRow, numberField, segments, select, setIdle } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setField, setText } from './dom.ts';
import { createObjectList } from './object-list.ts';
import { createOrientation } from './orientation.ts';

export interface ShapePanelProps {
  encoding: Encoding;
  keys: readonly KeyRef[];
  reference: number;
  info: KeysInfo | null;
  stats: SequenceStats | null;
  /** Number of threads for a frame. */
  threads: number | null;
  /** The method interpolates stretches. */
  hasStretches: boolean;
  /** The user's own files are open, so keys and objects can be chosen again. */
  canSample: boolean;
  /** Orientation of files that do not specify it; otherwise null. */
  orientation: Orientation | null;
  /** The chosen objects of the files; empty for all. */
  objects: readonly string[];
  /** Values restored by the reset button. */
  defaults: Encoding;
  disabled: boolean;
}

export interface ShapePanelEvents {
  onEncoding(change: Partial<Encoding>): void;
  onReset(): void;
  onOrient(orientation: Orientation): void;
  onObjects(names: string[]): void;
}

const NO_NAMES: readonly string[] = [];

const STRETCHES: readonly Choice<Stretch>[] = [
  { value: 'linear', label: 'Linear', hint: 'Blends stretches, as in the paper' },
  { value: 'log', label: 'Logarithmic', hint: 'Blends logarithms of stretches; no face turns inside out' },
];

/** `ghost`: the section on the ghost mesh. */
export function createShapePanel(ghost: HTMLElement, events: ShapePanelEvents): Component<ShapePanelProps> {
  const stretch = segments<Stretch>('Stretch', 'stretch', STRETCHES, (value) => events.onEncoding({ stretch: value }));
  const reference = select<string>('Reference pose', 'reference', [], (value) =>
    events.onEncoding({ referencePose: Number(value) }),
  );
  const patches = createPatches(events);
  const reset = button({
    label: 'Reset the shape options to their state when opened',
    testId: 'shape-reset',
    icon: 'reset',
    onClick: () => events.onReset(),
  });
  const facts = h('dl', { class: 'facts' });
  const orientation = createOrientation(events.onOrient);
  const objects = createObjectList(events.onObjects);
  const element = h(
    'section',
    { class: 'panel', id: 'panel-shape', 'aria-labelledby': 'shape-title', 'data-testid': 'panel-shape' },
    h('header', {}, h('h2', { id: 'shape-title' }, 'Shape'), reset),
    stretch.element,
    reference.element,
    patches.element,
    orientation.element,
    objects.element,
    ghost,
    h('details', { class: 'details', 'data-testid': 'mesh-report' }, h('summary', {}, 'Mesh details'), facts),
  );

  const draw = memo((props: ShapePanelProps) => {
    const { encoding, keys, info, stats } = props;
    stretch.update(
      encoding.stretch,
      props.hasStretches ? {} : { log: 'This method blends positions and has no stretches.', linear: '' },
    );
    reference.update(
      String(keys[props.reference]?.pose ?? ''),
      keys.map((key, index) => ({ value: String(key.pose), label: keyLabel(index, key.name) })),
    );
    patches.update(props);
    const names = Object.keys(DEFAULT_ENCODING) as (keyof Encoding)[];
    setIdle(
      reset,
      names.every((name) => encoding[name] === props.defaults[name]),
    );
    orientation.update(props.orientation);
    objects.update({ names: props.canSample ? (info?.objects ?? NO_NAMES) : NO_NAMES, taken: props.objects });
    drawFacts(facts, info, stats, props.threads);
  });
  return { element, update: draw };
}

function createPatches({ onEncoding }: ShapePanelEvents): Component<ShapePanelProps> {
  const count = numberField({
    label: 'Number of patches; empty: chosen automatically',
    testId: 'patches',
    min: 0,
    max: 5000,
    step: 1,
    empty: 0,
    onInput: (value) => onEncoding({ patches: Math.round(value) }),
  });
  const used = h('span', { class: 'muted', 'data-testid': 'patches-used' });
  const hint = 'Regions of the shape. Each region rotates as a whole, and its faces rotate within it';
  return {
    element: fieldRow(h('span', { class: 'label', title: hint }, 'Patches'), count, used),
    update({ encoding: { patches: chosen }, stats }) {
      setField(count, chosen === 0 ? '' : String(chosen));
      count.placeholder = stats && chosen === 0 ? `Auto (${stats.patches})` : 'Auto';
      setText(used, stats && chosen !== 0 && stats.patches !== chosen ? `${stats.patches} used` : '');
    },
  };
}

const drawFacts = (
  list: HTMLElement,
  info: KeysInfo | null,
  stats: SequenceStats | null,
  threads: number | null,
): void => {
  if (!info) return list.replaceChildren();
  const { report } = info;
  const rows: [string, number, boolean][] = [
    ['Vertices', report.vertices, true],
    ['Welded vertices', report.weldedVertices, report.weldedVertices !== report.vertices],
    ['Triangles', report.faces, true],
    ['Components', report.components, report.components > 1],
    ['Boundary edges', report.boundaryEdges, report.boundaryEdges > 0],
    ['Non-manifold edges', report.nonManifoldEdges, report.nonManifoldEdges > 0],
    ['Inconsistently oriented edges', report.inconsistentEdges, report.inconsistentEdges > 0],
    ['Degenerate triangles', report.degenerateFaces, report.degenerateFaces > 0],
    ['Duplicate triangles', report.duplicateFaces, report.duplicateFaces > 0],
    ['Unreferenced vertices', report.unreferencedVertices, report.unreferencedVertices > 0],
  ];
  const entries = rows.filter(([, , shown]) => shown).map(([label, value]) => [label, value.toLocaleString('en')]);
  if (stats) {
    if (stats.ghostFaces > 0) entries.push(['Ghost mesh', `${(stats.simplifyMs + stats.transferMs).toFixed(0)} ms`]);
    entries.push(
      ['Encoding', `${stats.encodeMs.toFixed(0)} ms`],
      ['Factorisation', `${(stats.orderMs + stats.factorMs + stats.arrangeMs).toFixed(0)} ms`],
      ['Factor', `${(stats.factorBytes / 1e6).toFixed(1)} MB`],
    );
  }
  if (threads) entries.push(['Threads', String(threads)]);
  list.replaceChildren(...entries.flatMap(([label, value]) => [h('dt', {}, label), h('dd', {}, value)]));
};
