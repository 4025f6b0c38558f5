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
export const METHODS = {
  play: ['void', 'Plays, as soon as it is seen.'],
  pause: ['void', 'Plays no more, and does not begin by itself.'],
  seek: ['Promise<void>', 'Resolves when the shape at that time is drawn.'],
  evaluate: ['Promise<Frame>', 'The shape at a time, drawn or not.'],
  toBlob: ['Promise<Blob>', 'A picture of what is shown.'],
  exportGLB: ['Promise<Blob>', 'A GLB with the motion as a morph-target animation.'],
  dismissPoster: ['void', 'Takes the poster away.'],
} as const;

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
      ...Object.entries(METHODS).map(([name, [text, description]]) => ({
        kind: 'method',
        name,
        return: { type: { text } },
        description,
      })),
    ],
    events: Object.entries(EVENTS).map(([name, { detail, doc }]) => ({
      name,
      type: { text: `CustomEvent<${detail}>` },
      description: doc,
    })),
    slots: ['', 'poster', 'controls', 'progress'].map((name) => ({ name })),
    cssParts: ['viewport', 'controls', 'play', 'timeline', 'key', 'thumb', 'name', 'progress', 'message'].map(
      (name) => ({ name }),
    ),
    cssProperties: ['key', 'between', 'beyond', 'foreground', 'background', 'progress'].map((name) => ({
      name: `--shape-spline-${name}`,
    })),
  };
  const exported = { kind: 'js', name: 'ShapeSplineElement', declaration: { name: 'ShapeSplineElement' } };
  return {
    schemaVersion: '1.0.0',
    modules: [
      { kind: 'javascript-module', path: 'element-class.js', declarations: [declaration], exports: [exported] },
    ],
  };
}
