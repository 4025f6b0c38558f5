/** Further options: of the shape spline, kept lengths and own paths; of fitted methods, their mesh and times. */
import { METHOD, OWN_METHOD } from '../engine/api/methods.ts';
import { MOTION } from '../engine/api/option-table.ts';
import { splineOptions, whyNoLengths, whyNoPaths } from '../model/spline-options.ts';
import type { Edited, RuledOut } from '../model/spline-options.ts';
import type { Motion } from '../model/state.ts';
import { segments } from './controls.ts';
import { createFitFields } from './fit-fields.ts';
import type { Component } from './dom.ts';
import { h, setHidden, setText } from './dom.ts';

const LENGTHS = [...Array(MOTION.keepLengths.most + 1).keys()].map(String);

const PATHS: Record<Motion['ownPaths'], { label: string; hint: string }> = {
  off: { label: 'Off', hint: 'As published: faces rotate with their patches' },
  absolute: { label: 'Absolute', hint: 'For keys of an animation' },
  root: { label: 'Relative', hint: 'To the largest patch: for sculpted poses. A key’s orientation has no effect' },
};

const REASONS: Record<RuledOut, string> = {
  ends: 'Requires free ends.',
  held: 'Not with parts held in place.',
  turns: 'Not with extra turns.',
  paths: 'Not with own paths.',
  transfer: 'Not with the paper’s transfer from a ghost mesh.',
};

export function createSplineOptions(onMotion: (change: Partial<Motion>) => void): Component<Edited> {
  const lengths = segments<string>(
    'Keep lengths',
    'keep-lengths',
    LENGTHS.map((value) => ({ value, label: value === '0' ? 'Off' : value })),
    (value) => onMotion({ keepLengths: Number(value) }),
  );
  const paths = segments<Motion['ownPaths']>(
    'Own paths of faces',
    'own-paths',
    MOTION.ownPaths.choices.map((value) => ({ value, ...PATHS[value] })),
    (value) => onMotion({ ownPaths: value }),
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
      paths.element,
      h('p', { class: 'hint' }, 'Each face rotates by itself from key to key: closer to sampled animations.'),
    ),
  );
  return {
    element: h('div', { class: 'group' }, details, fit.element),
    update(props) {
      const { keepLengths, ownPaths } = splineOptions(props);
      const { motion } = props;
      setHidden(details, motion.method !== OWN_METHOD);
      setHidden(mesh.element, keepLengths === 0);
      setHidden(fit.element, METHOD[motion.method].curve !== 'fitted');
      for (const fields of [mesh, fit]) fields.update(motion);
      const used = keepLengths > 0 ? ': lengths kept' : ownPaths !== 'off' ? ': own paths' : '';
      setText(summary, `Options of the shape spline${used}`);
      lengths.update(String(keepLengths), allRefused(LENGTHS.slice(1), whyNoLengths(props)));
      paths.update(ownPaths, allRefused(['absolute', 'root'], whyNoPaths(props)));
    },
  };
}

function allRefused<T extends string>(choices: readonly T[], why: RuledOut | null): Partial<Record<T, string>> {
  const entries = why ? choices.map((choice) => [choice, REASONS[why]]) : [];
  return Object.fromEntries(entries) as Partial<Record<T, string>>;
}
