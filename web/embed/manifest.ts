/** custom-elements.json: what editors and documentation read of the element. */
import { PROPERTIES, ROWS, attributeOf } from './attributes.ts';
import type { Row } from './attributes.ts';
import { EVENTS } from './events.ts';

/** As TypeScript has it. */
export function typeOf(row: Row): string {
  const words = (choices: readonly string[]): string => choices.map((choice) => `'${choice}'`).join(' | ');
  switch (row.kind) {
    case 'text':
      return 'string';
    case 'flag':
      return 'boolean';
    case 'number':
      return row.default === null ? 'number | null' : 'number';
    case 'numbers':
      return 'number[] | null';
    case 'words':
      return `(${words(row.choices)})[]`;
    case 'choice':
      return words([...new Set([...row.choices, row.default])]);
  }
}

/** What has no attribute. */
export const FIELDS = {
  keys: ['KeySource[] | null', 'Comes before `src`: addresses, Blobs or ArrayBuffers of one key each, or of all.'],
  duration: ['number', 'Length of what plays, in the unit of the keys; NaN before it is loaded.'],
  paused: ['boolean', 'Whether it does not play.'],
  stats: ['ShapeSplineStats', 'Frames that were computed and drawn, and what the last one took.'],
  report: ['MeshReport | null', 'What was found in the files.'],
} as const;
type Parameter = [name: string, type: string, doc: string];
/** A question mark after the name: may be left out. */
export const METHODS: Readonly<Record<string, { returns: string; doc: string; parameters?: readonly Parameter[] }>> = {
  play: { returns: 'void', doc: 'Plays, as soon as it is seen.' },
  pause: { returns: 'void', doc: 'Plays no more, and does not begin by itself.' },
  seek: {
    returns: 'Promise<void>',
    doc: 'Resolves when the shape at that time is drawn; rejects with a RangeError where that is no finite number.',
    parameters: [['t', 'number', 'The time, in the unit of the keys; it may lie beyond them.']],
  },
  evaluate: {
    returns: 'Promise<Frame>',
    doc: 'The shape at a time, drawn or not; its `release()` gives the arrays back.',
    parameters: [['t', 'number', 'The time, in the unit of the keys; it may lie beyond them.']],
  },
  toBlob: {
    returns: 'Promise<Blob>',
    doc: 'A picture of what is shown.',
    parameters: [
      ['options?', '{ type?: string; quality?: number }', 'MIME type, PNG by default, and quality in [0, 1].'],
    ],
  },
  exportGLB: {
    returns: 'Promise<Blob>',
    doc: 'A GLB with the motion as a morph-target animation.',
    parameters: [
      ['options?', "Partial<Omit<ExportOptions, 'format'>>", 'Frames, tolerance and compression, as of the engine.'],
    ],
  },
  dismissPoster: { returns: 'void', doc: 'Takes the poster away.' },
};
const SLOTS = {
  '': 'A caption, over the upper left corner.',
  poster: 'What is shown before the shape, instead of the picture of `poster`.',
  controls: 'Instead of the play button and the timeline, where there are controls.',
  progress: 'Instead of the bar, while it is fetched and computed.',
};
const PARTS = {
  viewport: 'The box in which the shape is drawn; it has the focus for the keyboard.',
  controls: 'The row with play button and timeline.',
  play: 'The button that plays and pauses.',
  timeline: 'The slider of the time.',
  key: 'The mark of a key on the timeline, one for each.',
  thumb: 'The mark of the time on the timeline.',
  name: 'The name of a method under its view, where several are compared.',
  progress: 'The bar at the top while it is fetched and computed.',
  message: 'What is wrong, in words.',
  retry: 'The button in the message that loads again, where that may help.',
};
const STYLES = {
  key: 'Colour of a key, on the timeline and, with `colour="phase"`, of the shape.',
  between: 'Colour of the shape between keys, with `colour="phase"`.',
  beyond: 'Colour of the shape beyond the first or last key, with `colour="phase"`.',
  foreground: 'Colour of text and controls.',
  background: 'Colour behind the shape.',
  progress: 'Colour of the bar while it is fetched and computed; that of a key by default.',
};

const listed = (words: Readonly<Record<string, string>>, before = ''): object[] =>
  Object.entries(words).map(([name, description]) => ({ name: `${before}${name}`, description }));

function exportOf(name: string, module = ''): object {
  return { kind: 'js', name, declaration: { name, ...(module && { module }) } };
}

/** In the form of custom-elements-manifest 1.0.0. */
export function customElementsManifest(): object {
  const described = PROPERTIES.map((property) => ({ property, row: ROWS[property] }));
  const declaration = {
    kind: 'class',
    name: 'ShapeSplineElement',
    tagName: 'shape-spline',
    customElement: true,
    superclass: { name: 'HTMLElement' },
    description: 'Smooth motion of a shape through a few key poses.',
    attributes: described.map(({ property, row }) => ({
      name: attributeOf(property),
      fieldName: property,
      type: { text: typeOf(row) },
      default: JSON.stringify(row.default),
      description: row.doc,
    })),
    members: [
      ...described.map(({ property, row }) => ({
        kind: 'field',
        name: property,
        attribute: attributeOf(property),
        type: { text: typeOf(row) },
        default: JSON.stringify(row.default),
        description: row.doc,
      })),
      ...Object.entries(FIELDS).map(([name, [text, description]]) => ({
        kind: 'field',
        name,
        type: { text },
        readonly: name !== 'keys',
        description,
      })),
      ...Object.entries(METHODS).map(([name, { returns, doc, parameters = [] }]) => ({
        kind: 'method',
        name,
        parameters: parameters.map(([parameter, text, description]) => ({
          name: parameter.replace('?', ''),
          type: { text },
          optional: parameter.endsWith('?'),
          description,
        })),
        return: { type: { text: returns } },
        description: doc,
      })),
    ],
    events: Object.entries(EVENTS).map(([name, { detail, doc }]) => ({
      name,
      type: { text: `CustomEvent<${detail}>` },
      description: doc,
    })),
    slots: listed(SLOTS),
    cssParts: listed(PARTS),
    cssProperties: listed(STYLES, '--shape-spline-'),
  };
  const kind = 'javascript-module';
  const path = 'element-class.js';
  const definition = {
    kind: 'custom-element-definition',
    name: 'shape-spline',
    declaration: { name: declaration.name, module: path },
  };
  return {
    schemaVersion: '1.0.0',
    modules: [
      { kind, path, declarations: [declaration], exports: [exportOf(declaration.name)] },
      { kind, path: 'element.js', declarations: [], exports: [definition] },
      { kind, path: 'cdn.js', declarations: [], exports: [definition, exportOf(declaration.name, path)] },
      {
        kind,
        path: 'canvas-viewer.js',
        declarations: [{ kind: 'class', name: 'CanvasViewer', description: 'A motion in a box of a page.' }],
        exports: [exportOf('CanvasViewer')],
      },
    ],
  };
}
