/** The ghost mesh (paper section 4.3): switch, options, and display. */
import { hasEffect } from '../engine/api/rules.ts';
import type { KeysInfo, SequenceStats } from '../engine/api/types.ts';
import { GHOST_FACES } from '../model/state.ts';
import type { Encoding, View } from '../model/state.ts';
import { checkbox } from './controls.ts';
import type { Component, Part } from './dom.ts';
import { group, h, setText } from './dom.ts';
import { optionField } from './option-field.ts';
import type { OptionProps } from './option-field.ts';

export interface GhostPanelProps extends OptionProps {
  view: View;
  info: KeysInfo | null;
  stats: SequenceStats | null;
}

export interface GhostPanelEvents {
  onEncoding(change: Partial<Encoding>): void;
  onView(change: Partial<View>): void;
}

const SHOWN = [
  ['ghostWire', 'ghost-wire', 'Wireframe'],
  ['ghostBeside', 'ghost-beside', 'Beside the shape'],
  ['ghostDifference', 'ghost-difference', 'Difference from the full solve'],
  ['ghostSizes', 'ghost-sizes', 'Also show 2× and 4× the faces'],
] as const;

/** `study`: the plot over sizes, available with and without a ghost. */
export function createGhostPanel<P extends GhostPanelProps>(events: GhostPanelEvents, study: Part<P>): Component<P> {
  const { onEncoding } = events;
  const toggle = checkbox('Ghost mesh', 'ghost', (on) => onEncoding({ ghostFaces: on ? GHOST_FACES : 0 }), 'N');
  const hint = h('p', { class: 'hint', 'data-testid': 'ghost-hint' });
  const used = h('span', { class: 'muted', 'data-testid': 'ghost-used' });
  const details = group<GhostPanelProps>(
    [
      optionField('ghostFaces', onEncoding, undefined, { beside: used }),
      optionField('transfer', onEncoding),
      optionField('placement', onEncoding),
      createShown(events),
    ],
    ({ encoding }) => encoding.ghostFaces > 0,
  );
  const sizes = group([study], ({ motion }) => hasEffect('ghostFaces', motion));
  const element = h(
    'section',
    { class: 'group ghost', id: 'panel-ghost', 'aria-label': 'Ghost mesh', 'data-testid': 'panel-ghost' },
    toggle.element,
    hint,
    details.element,
    sizes.element,
  );
  return {
    element,
    update(props) {
      const { motion, encoding, stats, info, disabled } = props;
      toggle.update(encoding.ghostFaces > 0, disabled);
      setText(
        hint,
        hasEffect('ghostFaces', motion)
          ? 'The motion is computed on a coarse mesh and transferred to the full shape.'
          : 'This method uses no ghost mesh.',
      );
      setText(used, encoding.ghostFaces > 0 && stats ? usedText(stats.ghostFaces, info?.report.faces ?? 0) : '');
      details.update(props);
      sizes.update(props);
    },
  };
}

/** Display options of the ghost mesh. */
function createShown({ onView }: GhostPanelEvents): Component<GhostPanelProps> {
  const boxes = SHOWN.map(([name, testId, label]) => checkbox(label, testId, (on) => onView({ [name]: on })));
  const chips = h('div', { class: 'chips' }, ...boxes.map(({ element }) => element));
  return {
    element: h('fieldset', { class: 'field' }, h('legend', {}, 'Show'), chips),
    update({ view, motion }) {
      const follows = hasEffect('ghostFaces', motion);
      SHOWN.forEach(([name], index) => {
        // Other sizes are shown by their difference from the full solve.
        const implied = name === 'ghostDifference' && view.ghostSizes;
        boxes[index]!.update(view[name] || implied, !follows || implied);
      });
    },
  };
}

function usedText(ghost: number, faces: number): string {
  return ghost === 0 ? 'not used' : `${ghost.toLocaleString('en')} of ${faces.toLocaleString('en')}`;
}
