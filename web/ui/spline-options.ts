/** Further options: of the shape spline, kept lengths; of fitted methods, their mesh and times. */
import { METHOD, OWN_METHOD } from '../engine/api/methods.ts';
import { MOTION } from '../engine/api/option-table.ts';
import type { RuledOption } from '../engine/api/rules.ts';
import { keptLengths, keepLengthsConflict } from '../model/spline-options.ts';
import type { Edited } from '../model/spline-options.ts';
import type { Motion } from '../model/state.ts';
import { segments } from './controls.ts';
import { createFitFields } from './fit-fields.ts';
import type { Component } from './dom.ts';
import { h, setHidden, setText } from './dom.ts';

const LENGTHS = [...Array(MOTION.keepLengths.max + 1).keys()].map(String);

const HELD = 'Not with parts held in place.';
const REASONS: Partial<Record<RuledOption, string>> = {
  boundary: 'Requires free ends.',
  hold: HELD,
  pins: HELD,
  turns: 'Not with extra turns.',
};

export function createSplineOptions(onMotion: (change: Partial<Motion>) => void): Component<Edited> {
  const lengths = segments<string>(
    'Keep lengths',
    'keep-lengths',
    LENGTHS.map((value) => ({ value, label: value === '0' ? 'Off' : value })),
    (value) => onMotion({ keepLengths: Number(value) }),
  );
  const mesh = createFitFields(['spaceFaces'], 'keep-lengths', onMotion);
  const fit = createFitFields(['spaceFaces', 'spaceSamples'], 'fit', onMotion);
  const summary = h('summary', { 'data-testid': 'spline-options' });
  const details = h(
    'details',
    { class: 'details' },
    summary,
    h(
      'div',
      { class: 'group' },
      lengths.element,
      h('p', { class: 'hint' }, 'Shapes between two keys whose edges keep their lengths: for cloth and paper.'),
      mesh.element,
    ),
  );
  return {
    element: h('div', { class: 'group' }, details, fit.element),
    update(props) {
      const keepLengths = keptLengths(props);
      const { motion } = props;
      setHidden(details, motion.method !== OWN_METHOD);
      setHidden(mesh.element, keepLengths === 0);
      setHidden(fit.element, METHOD[motion.method].curve !== 'fitted');
      for (const fields of [mesh, fit]) fields.update(motion);
      setText(summary, `Options of the shape spline${keepLengths > 0 ? ': lengths kept' : ''}`);
      lengths.update(String(keepLengths), allRefused(LENGTHS.slice(1), keepLengthsConflict(props)));
    },
  };
}

function allRefused<T extends string>(choices: readonly T[], why: RuledOption | null): Partial<Record<T, string>> {
  const entries = why ? choices.map((choice) => [choice, REASONS[why] ?? '']) : [];
  return Object.fromEntries(entries) as Partial<Record<T, string>>;
}
