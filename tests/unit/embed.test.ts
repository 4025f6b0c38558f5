/** The table of the element's attributes: written values are parsed back, and invalid ones are reported. */
import { describe, expect, it } from 'vitest';
import { ATTRIBUTES, PROPERTIES, ROWS, attributeOf, propertyOf } from '../../web/embed/attributes.ts';
import { customElementsManifest } from '../../web/embed/manifest.ts';
import { readAttribute, writeAttribute } from '../../web/embed/values.ts';
import { orbitOf, targetOf } from '../../web/model/camera-words.ts';
import { samples } from '../element-samples.ts';

describe('every row of the table', () => {
  it.each(PROPERTIES)('%s', (property) => {
    const row = ROWS[property];
    expect(propertyOf(attributeOf(property))).toBe(property);
    expect(readAttribute(row, null)).toEqual({ value: row.default, problem: null });
    for (const value of samples(row))
      expect(readAttribute(row, writeAttribute(row, value) ?? null)).toEqual({ value, problem: null });
    expect(row.doc).toMatch(/^[A-Z].*\.$/s);
  });
});

it('"false" counts as false and is reported', () => {
  expect(readAttribute(ROWS.autoplay, 'false')).toMatchObject({ value: false, problem: expect.any(String) });
  expect(readAttribute(ROWS.loop, 'false')).toMatchObject({ value: '', problem: expect.any(String) });
});

it('an invalid value is reported, and the default is used', () => {
  expect(readAttribute(ROWS.boundary, 'round')).toMatchObject({ value: 'natural', problem: expect.any(String) });
  expect(readAttribute(ROWS.playbackRate, '0')).toMatchObject({ value: 1, problem: expect.any(String) });
  for (const range of ['1', '2 1', 'a b'])
    expect(readAttribute(ROWS.range, range)).toMatchObject({ value: null, problem: expect.any(String) });
  expect(readAttribute(ROWS.cameraOrbit, '30 75deg')).toMatchObject({ value: '', problem: expect.any(String) });
  expect(readAttribute(ROWS.cameraTarget, 'there')).toMatchObject({ value: '', problem: expect.any(String) });
});

it('the manifest lists every attribute', () => {
  const { modules } = customElementsManifest() as {
    modules: { declarations: { attributes: { name: string }[] }[] }[];
  };
  expect(modules[0]!.declarations[0]!.attributes.map(({ name }) => name)).toEqual([...ATTRIBUTES]);
});

it('every entry can be imported without a DOM', async () => {
  const { ShapeSplineElement } = await import('../../web/embed/shape-spline.ts');
  await import('../../web/embed/register.ts');
  expect(ShapeSplineElement.observedAttributes).toBe(ATTRIBUTES);
});

it('cameras in words', () => {
  expect(orbitOf('90deg auto 105%')).toEqual({
    theta: Math.PI / 2,
    phi: (75 * Math.PI) / 180,
    radius: { share: 1.05 },
  });
  expect(orbitOf('0deg 90deg 50cm')).toMatchObject({ radius: { distance: 0.5 } });
  expect(orbitOf('30 75deg 105%')).toBeNull();
  expect(targetOf('0m auto -20cm')).toEqual([0, NaN, -0.2]);
});
