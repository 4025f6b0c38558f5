/** The ghost mesh (paper section 4.3): switch, options, and display. */
import { ENCODING } from '../engine/api/option-table.ts';
import type { SequenceStats, Transfer } from '../engine/api/types.ts';
import { DEFAULT_ENCODING, GHOST_FACES } from '../model/state.ts';
import type { Encoding, View } from '../model/state.ts';
import type { Choice } from './controls.ts';
import { button, checkbox, fieldRow, numberField, segments, setIdle } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setField, setHidden, setText } from './dom.ts';

export interface GhostPanelProps {
  encoding: Encoding;
  view: View;
  /** Number of faces of the shape. */
  faces: number;
  stats: SequenceStats | null;
  lriMethod: boolean;
  disabled: boolean;
}

export interface GhostPanelEvents {
  onEncoding(change: Partial<Encoding>): void;
  onView(change: Partial<View>): void;
}

const TRANSFERS: readonly Choice<Transfer>[] = [
  {
    value: 'exact',
    label: 'Exact',
    hint: 'Passes through every key; details missing from the ghost are interpolated as well',
  },
  {
    value: 'paper',
    label: 'As published',
    hint: 'The details of the reference follow the ghost; the motion passes other keys approximately',
  },
];

/** `study`: the plot over sizes, available with and without a ghost. */
export function createGhostPanel(events: GhostPanelEvents, study: HTMLElement): Component<GhostPanelProps> {
  const toggle = checkbox('Ghost mesh', 'ghost', (on) => events.onEncoding({ ghostFaces: on ? GHOST_FACES : 0 }), 'N');
  const hint = h('p', { class: 'hint', 'data-testid': 'ghost-hint' });
  const faces = createFaces(events);
  const transfer = segments<Transfer>('Transfer', 'transfer', TRANSFERS, (value) =>
    events.onEncoding({ transfer: value }),
  );
  const placement = checkbox('Optimal vertex placement (off the surface)', 'placement', (on) =>
    events.onEncoding({ placement: on ? 'optimal' : DEFAULT_ENCODING.placement }),
  );
  const shown = createShown(events);
  const details = h(
    'div',
    { class: 'group', id: 'ghost-details' },
    faces.element,
    transfer.element,
    placement.element,
    shown.element,
  );
  const element = h(
    'section',
    { class: 'group ghost', 'aria-label': 'Ghost mesh', 'data-testid': 'panel-ghost' },
    toggle.element,
    hint,
    details,
    study,
  );

  const draw = memo((props: GhostPanelProps) => {
    const { encoding, lriMethod, disabled } = props;
    toggle.update(encoding.ghostFaces > 0, disabled);
    setText(
      hint,
      lriMethod
        ? 'The motion is computed on a coarse mesh and transferred to the full shape.'
        : 'This method uses no ghost mesh.',
    );
    setHidden(details, encoding.ghostFaces === 0);
    setHidden(study, !lriMethod);
    faces.update(props);
    transfer.update(encoding.transfer);
    placement.update(encoding.placement === 'optimal', disabled);
    shown.update(props);
  });
  return { element, update: draw };
}

function createFaces({ onEncoding }: GhostPanelEvents): Component<GhostPanelProps> {
  const count = numberField({
    label: 'Faces of the ghost mesh',
    testId: 'ghost-faces',
    min: ENCODING.ghostFaces.min,
    max: 1_000_000,
    step: 100,
    onInput: (value) => onEncoding({ ghostFaces: Math.round(value) }),
  });
  const used = h('span', { class: 'muted', 'data-testid': 'ghost-used' });
  const reset = button({
    label: `Reset the faces to ${GHOST_FACES.toLocaleString('en')}`,
    testId: 'ghost-faces-reset',
    icon: 'reset',
    onClick: () => onEncoding({ ghostFaces: GHOST_FACES }),
  });
  return {
    element: fieldRow('Faces', count, used, reset),
    update({ encoding: { ghostFaces }, stats, faces }) {
      setField(count, String(ghostFaces));
      setText(used, ghostFaces > 0 && stats ? usedText(stats.ghostFaces, faces) : '');
      setIdle(reset, ghostFaces === GHOST_FACES);
    },
  };
}

/** Display options of the ghost mesh. */
function createShown({ onView }: GhostPanelEvents): Component<GhostPanelProps> {
  const wire = checkbox('Wireframe', 'ghost-wire', (on) => onView({ ghostWire: on }));
  const beside = checkbox('Beside the shape', 'ghost-beside', (on) => onView({ ghostBeside: on }));
  const difference = checkbox('Difference from the full solve', 'ghost-difference', (on) =>
    onView({ ghostDifference: on }),
  );
  const sizes = checkbox('Also show 2× and 4× the faces', 'ghost-sizes', (on) => onView({ ghostSizes: on }));
  const chips = h('div', { class: 'chips' }, wire.element, beside.element, difference.element, sizes.element);
  return {
    element: h('fieldset', { class: 'field' }, h('legend', {}, 'Show'), chips),
    update({ view, lriMethod }) {
      wire.update(view.ghostWire, !lriMethod);
      beside.update(view.ghostBeside, !lriMethod);
      // Other sizes are shown by their difference from the full solve.
      difference.update(view.ghostDifference || view.ghostSizes, !lriMethod || view.ghostSizes);
      sizes.update(view.ghostSizes, !lriMethod);
    },
  };
}

function usedText(ghost: number, faces: number): string {
  return ghost === 0 ? 'not used' : `${ghost.toLocaleString('en')} of ${faces.toLocaleString('en')}`;
}
