/** Encoding of the shape: stretches, reference, patches, and the import report. */
import type { KeysInfo, SequenceStats } from '../engine/api/types.ts';
import { keyChoices } from '../model/key-names.ts';
import type { Orientation } from '../model/orientation.ts';
import type { Encoding } from '../model/state.ts';
import { referenceKey } from '../model/state.ts';
import type { Component, Part } from './dom.ts';
import { h, memo, setText } from './dom.ts';
import { createGhostPanel } from './ghost-panel.ts';
import type { GhostPanelEvents, GhostPanelProps } from './ghost-panel.ts';
import { createObjectList } from './object-list.ts';
import { fillPanel, optionControl, optionField } from './option-field.ts';
import type { OptionPanelProps } from './option-field.ts';
import { createOrientation } from './orientation.ts';

export interface ShapePanelProps extends OptionPanelProps<Encoding>, GhostPanelProps {
  /** Number of threads for a frame. */
  threads: number | null;
  /** The user's own files are open, so keys and objects can be chosen again. */
  canSample: boolean;
  /** Orientation of files that do not specify it; otherwise null. */
  orientation: Orientation | null;
  /** The chosen objects of the files; empty for all. */
  objects: readonly string[];
}

export interface ShapePanelEvents extends GhostPanelEvents {
  onReset(): void;
  onOrient(orientation: Orientation): void;
  onObjects(names: string[]): void;
}

/** Fills the panel. `study`: the plot over sizes of the ghost mesh. */
export function createShapePanel(
  panel: HTMLElement,
  events: ShapePanelEvents,
  study: Part<ShapePanelProps>,
): Component<ShapePanelProps> {
  const { onEncoding, onReset, onOrient, onObjects } = events;
  return fillPanel<'encoding', ShapePanelProps>(panel, 'encoding', onReset, [
    optionField('stretch', onEncoding),
    createReference(onEncoding),
    createPatches(onEncoding),
    createOrientation(onOrient),
    createObjectList(onObjects),
    createGhostPanel(events, study),
    createFacts(),
  ]);
}

function createReference(onEncoding: ShapePanelEvents['onEncoding']): Component<ShapePanelProps> {
  const { element, update } = optionControl('reference', (value) => onEncoding({ referencePose: Number(value) }));
  return {
    element,
    update: (props) => update(props.keys[referenceKey(props)]?.pose ?? null, { choices: keyChoices(props.keys) }),
  };
}

function createPatches(onEncoding: ShapePanelEvents['onEncoding']): Component<ShapePanelProps> {
  const used = h('span', { class: 'muted', 'data-testid': 'patches-used' });
  return optionField(
    'patches',
    onEncoding,
    ({ encoding: { patches }, stats }) => {
      setText(used, stats && patches !== 0 && stats.patches !== patches ? `${stats.patches} used` : '');
      return patches === 0 ? { text: '', placeholder: stats ? `Auto (${stats.patches})` : 'Auto' } : {};
    },
    { beside: used },
  );
}

function createFacts(): Component<ShapePanelProps> {
  const facts = h('dl', { class: 'facts' });
  const draw = memo(({ info, stats, threads }: Pick<ShapePanelProps, 'info' | 'stats' | 'threads'>) =>
    drawFacts(facts, info, stats, threads),
  );
  return {
    element: h('details', { class: 'details', 'data-testid': 'mesh-report' }, h('summary', {}, 'Mesh details'), facts),
    update: ({ info, stats, threads }) => draw({ info, stats, threads }),
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
