/** custom-elements.json, for editors and documentation. */
import { PROPERTIES, ROWS, attributeOf } from './attributes.ts';
import type { Row } from './attributes.ts';
import { EVENTS } from './events.ts';

/** The TypeScript type. */
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

/** Properties without an attribute. */
export const FIELDS = {
  keys: ['KeySource[] | null', 'Overrides `src`: URLs, Blobs or ArrayBuffers, one per key or one with all keys.'],
  duration: ['number', 'Length of the playing range, in seconds on the scale of the key times; NaN before loading.'],
  paused: ['boolean', 'Whether playback is paused.'],
  stats: ['ShapeSplineStats', 'Numbers of frames computed and drawn; computing time of the last one in milliseconds.'],
  report: ['MeshReport | null', 'Report on the mesh in the files; null before loading.'],
} as const;
type Parameter = [name: string, type: string, doc: string];
/** A question mark after a name marks an optional parameter. */
export const METHODS: Readonly<Record<string, { returns: string; doc: string; parameters?: readonly Parameter[] }>> = {
  play: { returns: 'void', doc: 'Starts playback as soon as the element is visible.' },
  pause: { returns: 'void', doc: 'Pauses playback. It does not restart by itself.' },
  seek: {
    returns: 'Promise<void>',
    doc: 'Resolves when the shape at that time is drawn; rejects with a RangeError if the time is not finite.',
    parameters: [['t', 'number', 'Time in seconds, on the scale of the key times. It can be beyond the keys.']],
  },
  evaluate: {
    returns: 'Promise<Frame>',
    doc: 'The shape at a time, without showing it. Its `release()` allows its arrays to be reused.',
    parameters: [['t', 'number', 'Time in seconds, on the scale of the key times. It can be beyond the keys.']],
  },
  toBlob: {
    returns: 'Promise<Blob>',
    doc: 'An image of the current view.',
    parameters: [
      ['options?', '{ type?: string; quality?: number }', 'MIME type, PNG by default, and quality in [0, 1].'],
    ],
  },
  exportGLB: {
    returns: 'Promise<Blob>',
    doc: 'A GLB with the motion as a morph-target animation.',
    parameters: [
      [
        'options?',
        "Partial<Omit<ExportOptions, 'format'>>",
        'Frames, tolerance, compression and other export options of the engine.',
      ],
    ],
  },
  dismissPoster: { returns: 'void', doc: 'Removes the poster.' },
};
const SLOTS = {
  '': 'A caption over the upper left corner.',
  poster: 'Shown before the shape, instead of the image of `poster`.',
  controls: 'Replaces the play button and the timeline; shown only with `controls`.',
  progress: 'Replaces the progress bar.',
};
const PARTS = {
  viewport: 'The box in which the shape is drawn. It takes keyboard focus if keys can rotate or play the shape.',
  controls: 'The row with play button and timeline.',
  play: 'The button that plays and pauses.',
  timeline: 'The time slider.',
  key: 'The mark of a key on the timeline, one per key.',
  thumb: 'The playhead on the timeline.',
  name: 'The name of a method under its view, if several are compared.',
  progress: 'The progress bar at the top.',
  message: 'The error message.',
  retry: 'The retry button in the error message, shown if a retry may help.',
};
const STYLES = {
  key: 'Colour of the keys on the timeline and, with `colour="phase"`, of the shape at a key.',
  between: 'Colour of the shape between keys, with `colour="phase"`.',
  beyond: 'Colour of the shape beyond the first or last key, with `colour="phase"`.',
  foreground: 'Colour of text and controls.',
  background: 'Colour behind the shape.',
  progress: 'Colour of the progress bar; default: the colour of a key.',
};

const listed = (words: Readonly<Record<string, string>>, before = ''): object[] =>
  Object.entries(words).map(([name, description]) => ({ name: `${before}${name}`, description }));

function exportOf(name: string, module = ''): object {
  return { kind: 'js', name, declaration: { name, ...(module && { module }) } };
}

/** The manifest in the format custom-elements-manifest 1.0.0. */
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
        declarations: [{ kind: 'class', name: 'CanvasViewer', description: 'Shows a motion in any HTML element.' }],
        exports: [exportOf('CanvasViewer')],
      },
    ],
  };
}
