/** The ghost mesh (paper section 4.3): whether a coarse mesh leads the shape, how, and what of it is shown. */
import { ENCODING } from '../engine/api/option-table.ts';
import type { SequenceStats, Transfer } from '../engine/api/types.ts';
import { DEFAULT_ENCODING, GHOST_FACES } from '../model/state.ts';
import type { Encoding, View } from '../model/state.ts';
import type { Choice } from './controls.ts';
import { button, checkbox, numberField, segments } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setField, setHidden, setText } from './dom.ts';

export interface GhostPanelProps {
  encoding: Encoding;
  view: View;
  /** Of the shape. */
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
    hint: 'Passes through every key: the details that the ghost lacks are interpolated, too',
  },
  {
    value: 'paper',
    label: 'As published',
    hint: 'The details of the reference follow the ghost; other keys are met approximately',
  },
];

/** `study`: the plot over sizes, which can be made whether a ghost leads now or not. */
export function createGhostPanel(events: GhostPanelEvents, study: HTMLElement): Component<GhostPanelProps> {
  const toggle = checkbox('Ghost mesh', 'ghost', (on) => events.onEncoding({ ghostFaces: on ? GHOST_FACES : 0 }), 'N');
  const hint = h('p', { class: 'hint', 'data-testid': 'ghost-hint' });
  const faces = numberField({
    label: 'Faces of the ghost mesh',
    testId: 'ghost-faces',
    min: ENCODING.ghostFaces.least,
    max: 1_000_000,
    step: 100,
    onInput: (value) => events.onEncoding({ ghostFaces: Math.round(value) }),
  });
  const used = h('span', { class: 'muted', 'data-testid': 'ghost-used' });
  const reset = button({
    label: `Reset the faces to ${GHOST_FACES.toLocaleString('en')}`,
    testId: 'ghost-faces-reset',
    icon: 'reset',
    onClick: () => events.onEncoding({ ghostFaces: GHOST_FACES }),
  });
  const transfer = segments<Transfer>('Transfer', 'transfer', TRANSFERS, (value) =>
    events.onEncoding({ transfer: value }),
  );
  const placement = checkbox('Vertices may leave the surface', 'placement', (on) =>
    events.onEncoding({ placement: on ? 'optimal' : DEFAULT_ENCODING.placement }),
  );
  const wire = checkbox('Wireframe', 'ghost-wire', (on) => events.onView({ ghostWire: on }));
  const beside = checkbox('Beside the shape', 'ghost-beside', (on) => events.onView({ ghostBeside: on }));
  const difference = checkbox('Difference from the full solve', 'ghost-difference', (on) =>
    events.onView({ ghostDifference: on }),
  );
  const sizes = checkbox('Twice and four times the faces', 'ghost-sizes', (on) => events.onView({ ghostSizes: on }));
  const shown = h(
    'fieldset',
    { class: 'field' },
    h('legend', {}, 'Show'),
    h('div', { class: 'chips' }, wire.element, beside.element, difference.element, sizes.element),
  );
  const details = h(
    'div',
    { class: 'group', id: 'ghost-details' },
    h('div', { class: 'field row' }, h('span', { class: 'label' }, 'Faces'), faces, used, reset),
    transfer.element,
    placement.element,
    shown,
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
    const { encoding, view, stats } = props;
    const on = encoding.ghostFaces > 0;
    toggle.update(on, props.disabled);
    setText(
      hint,
      props.lriMethod
        ? 'A coarse mesh leads the motion and the full shape follows it.'
        : 'This method blends positions and uses no ghost mesh.',
    );
    setHidden(details, !on);
    setHidden(study, !props.lriMethod);
    setField(faces, String(encoding.ghostFaces));
    setText(used, on && stats ? usedText(stats.ghostFaces, props.faces) : '');
    setAttribute(reset, 'data-idle', encoding.ghostFaces === GHOST_FACES);
    reset.disabled = encoding.ghostFaces === GHOST_FACES;
    transfer.update(encoding.transfer);
    placement.update(encoding.placement === 'optimal', props.disabled);
    wire.update(view.ghostWire, !props.lriMethod);
    beside.update(view.ghostBeside, !props.lriMethod);
    // Other sizes are shown by what they differ from the full solve.
    difference.update(view.ghostDifference || view.ghostSizes, !props.lriMethod || view.ghostSizes);
    sizes.update(view.ghostSizes, !props.lriMethod);
  });
  return { element, update: draw };
}

function usedText(ghost: number, faces: number): string {
  return ghost === 0 ? 'not used' : `${ghost.toLocaleString('en')} of ${faces.toLocaleString('en')}`;
}
