/** The examples: the script of a typical page, and the tables of the element's interface. */
import '../register.ts';
import { h } from '../../ui/dom.ts';
import { PROPERTIES, ROWS, attributeOf } from '../attributes.ts';
import { EVENTS } from '../events.ts';
import { FIELDS, METHODS, typeOf } from '../manifest.ts';
import type { ShapeSplineElement } from '../shape-spline.ts';
import { takeFiles } from './dropped.ts';
import droppedScript from './dropped.ts?raw';
import reactComponent from './react-component.tsx?raw';
import { followScroll } from './scrolled.ts';
import scrolledScript from './scrolled.ts?raw';

const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

function list(id: string, head: readonly string[], rows: readonly (readonly string[])[]): void {
  byId(id).append(
    h('thead', {}, h('tr', {}, ...head.map((name) => h('th', { scope: 'col' }, name)))),
    h('tbody', {}, ...rows.map((cells) => h('tr', {}, ...cells.map((text) => h('td', {}, text))))),
  );
}

/** Rewrites imports as in a page that uses the package. */
const forPages = (text: string): string => text.replace("'../shape-spline.ts'", "'shapespline/element-class'").trim();

/** The markup of a page with its files in the same folder. */
function markupOf(id: string): string {
  const shape = byId(id).cloneNode() as HTMLElement;
  shape.removeAttribute('id');
  shape.setAttribute('src', shape.getAttribute('src')!.split('/').at(-1)!);
  return shape.outerHTML.replaceAll('=""', '').replaceAll(/\s+/g, ' ');
}

for (const id of ['plain', 'compared']) byId(`${id}-markup`).textContent = markupOf(id);
// React is fetched when its example is near the view.
new IntersectionObserver(async (entries, observer) => {
  if (!entries.some((entry) => entry.isIntersecting)) return;
  observer.disconnect();
  const { showReact } = await import('./live-react.tsx');
  showReact(byId('in-react'), byId<ShapeSplineElement>('plain').src);
}).observe(byId('in-react'));
followScroll(byId<ShapeSplineElement>('scrolled'));
takeFiles(byId<HTMLInputElement>('files'), byId<ShapeSplineElement>('dropped'));
byId('scrolled-script').textContent = forPages(scrolledScript);
byId('dropped-script').textContent = forPages(droppedScript);
byId('react').textContent = reactComponent.trim();
list(
  'attributes',
  ['Attribute', 'Type', 'Default', 'What it does'],
  PROPERTIES.map((property) => {
    const row = ROWS[property];
    return [attributeOf(property), typeOf(row), JSON.stringify(row.default), row.doc];
  }),
);
list(
  'events',
  ['Event', 'Detail', 'When'],
  Object.entries(EVENTS).map(([name, { detail, doc }]) => [name, detail, doc]),
);
list(
  'members',
  ['Name', 'Type', 'What it is'],
  [
    ...Object.entries(FIELDS).map(([name, [type, doc]]) => [name, type, doc]),
    ...Object.entries(METHODS).map(([name, { returns, doc, parameters = [] }]) => [
      `${name}(${parameters.map(([parameter]) => parameter).join(', ')})`,
      returns,
      doc,
    ]),
  ],
);
