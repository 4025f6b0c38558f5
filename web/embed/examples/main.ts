/** The examples: what a page's own script would do, and the table of attributes. */
import '../register.ts';
import { h } from '../../ui/dom.ts';
import { PROPERTIES, ROWS, attributeOf } from '../attributes.ts';
import { typeOf } from '../manifest.ts';
import type { ShapeSplineElement } from '../shape-spline.ts';

const element = (id: string): ShapeSplineElement => document.getElementById(id) as ShapeSplineElement;

function followScroll(shape: ShapeSplineElement): void {
  const follow = (): void => {
    const { top, height } = shape.getBoundingClientRect();
    const share = 1 - (top + height) / (innerHeight + height);
    if (shape.duration > 0 && share >= 0 && share <= 1) shape.currentTime = share * shape.duration;
  };
  shape.addEventListener('load', follow);
  addEventListener('scroll', follow, { passive: true });
}

function takeFiles(input: HTMLInputElement, shape: ShapeSplineElement): void {
  input.addEventListener('change', () => {
    shape.keys = [...(input.files ?? [])];
  });
}

function listAttributes(table: HTMLElement): void {
  table.append(h('tr', {}, ...['Attribute', 'Type', 'Default', 'What it does'].map((name) => h('th', {}, name))));
  for (const property of PROPERTIES) {
    const row = ROWS[property];
    const cells = [attributeOf(property), typeOf(row), JSON.stringify(row.default), row.doc];
    table.append(h('tr', {}, ...cells.map((text) => h('td', {}, text))));
  }
}

followScroll(element('scrolled'));
takeFiles(document.getElementById('files') as HTMLInputElement, element('dropped'));
listAttributes(document.getElementById('attributes')!);
