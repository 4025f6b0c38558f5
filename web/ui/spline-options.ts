/** Further options: of the shape spline, kept lengths; of fitted methods, their mesh and times. */
import { OWN_METHOD } from '../engine/api/methods.ts';
import { hasEffect } from '../engine/api/rules.ts';
import { keptLengths } from '../model/spline-options.ts';
import type { Motion } from '../model/state.ts';
import type { Component } from './dom.ts';
import { group, h, setHidden, setText } from './dom.ts';
import { optionField } from './option-field.ts';
import type { OptionProps } from './option-field.ts';

export function createSplineOptions(onMotion: (change: Partial<Motion>) => void): Component<OptionProps> {
  const spline = group([
    optionField('keepLengths', onMotion),
    group<OptionProps>(
      [optionField('spaceFaces', onMotion, undefined, { prefix: 'keep-lengths-' })],
      ({ motion }) => motion.keepLengths > 0,
    ),
  ]);
  const fit = group<OptionProps>(
    (['spaceFaces', 'spaceSamples'] as const).map((name) => optionField(name, onMotion, undefined, { prefix: 'fit-' })),
    ({ motion }) => hasEffect('spaceSamples', motion),
  );
  const summary = h('summary', { 'data-testid': 'spline-options' });
  const details = h('details', { class: 'details' }, summary, spline.element);
  return {
    element: h('div', { class: 'group' }, details, fit.element),
    update(props) {
      const keepLengths = keptLengths(props);
      setHidden(details, props.motion.method !== OWN_METHOD);
      setText(summary, `Options of the shape spline${keepLengths > 0 ? ': lengths kept' : ''}`);
      spline.update({ ...props, motion: { ...props.motion, keepLengths } });
      fit.update(props);
    },
  };
}
