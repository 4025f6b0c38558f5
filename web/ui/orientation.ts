/** Orientation of files that do not specify it: up axis and unit. */
import type { Orientation } from '../model/orientation.ts';
import { segments, select } from './controls.ts';
import type { Component } from './dom.ts';
import { h, setHidden } from './dom.ts';

const UNITS: readonly [number, string][] = [
  [1, 'metres'],
  [0.01, 'centimetres'],
  [0.001, 'millimetres'],
  [0.0254, 'inches'],
  [0.3048, 'feet'],
];

/** Hidden without an orientation. */
export function createOrientation(
  onChange: (orientation: Orientation) => void,
): Component<{ orientation: Orientation | null }> {
  let present: Orientation = { up: 'y', unit: 1 };
  const up = segments<Orientation['up']>(
    'Up axis of the files',
    'up-axis',
    [
      { value: 'y', label: 'Y', hint: 'As in most animation programs' },
      { value: 'z', label: 'Z', hint: 'As in CAD, scans and 3D printing' },
    ],
    (value) => onChange({ ...present, up: value }),
  );
  const unit = select<string>('Unit of the files', 'file-unit', [], (value) =>
    onChange({ ...present, unit: Number(value) }),
  );
  const element = h('div', { class: 'group', hidden: true, 'data-testid': 'orientation' }, up.element, unit.element);
  return {
    element,
    update({ orientation }) {
      setHidden(element, orientation === null);
      if (!orientation) return;
      present = orientation;
      up.update(orientation.up);
      const known = UNITS.some(([value]) => value === orientation.unit)
        ? UNITS
        : [...UNITS, [orientation.unit, `${orientation.unit} m`] as const];
      unit.update(
        String(orientation.unit),
        known.map(([value, label]) => ({ value: String(value), label })),
      );
    },
  };
}
