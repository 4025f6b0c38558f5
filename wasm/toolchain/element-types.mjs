// Types of the custom element for those who write it in TypeScript's markup, made of its manifest: one table says which
// attributes there are.

/** For `document.querySelector('shape-spline')`. */
export const elementTypes = `import type { ShapeSplineElement } from './element-class.js';

declare global {
  interface HTMLElementTagNameMap {
    'shape-spline': ShapeSplineElement;
  }
}

export {};
`;

const HEAD = `import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type { KeySource, ShapeSplineElement, ShapeSplineEventMap, ShapeSplineProperties } from './element-class.js';
`;

const PARTS = `/** React 19 and others listen to events by these names. */
export type ShapeSplineListeners = {
  [N in keyof ShapeSplineEventMap as \`on\${N}\`]?: ((event: ShapeSplineEventMap[N]) => void) | undefined;
};

/** They set properties, too: those whose names are not attributes'. */
export type ShapeSplineExtras = ShapeSplineListeners & {
  [N in Exclude<keyof ShapeSplineProperties, keyof ShapeSplineAttributes>]?: ShapeSplineProperties[N] | undefined;
} & {
  /** Comes before src: addresses, Blobs or ArrayBuffers of one key each, or of all. */
  keys?: readonly KeySource[] | null | undefined;
};

export type ShapeSplineProps = DetailedHTMLProps<HTMLAttributes<ShapeSplineElement>, ShapeSplineElement> &
  ShapeSplineAttributes &
  ShapeSplineExtras;

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'shape-spline': ShapeSplineProps;
    }
  }
}
`;

// An attribute is text; what it stands for may be written as what it is.
const asWritten = (type) => {
  if (type === 'boolean') return "boolean | '' | 'true' | 'false'";
  if (type.startsWith('number')) return 'number | string';
  return type === 'string' || type.includes('[]') ? 'string' : type;
};

/** `jsx.d.ts`: the element in React 19; the attributes alone serve other frameworks. */
export function jsxTypes(manifest) {
  const { attributes } = manifest.modules[0].declarations[0];
  const members = attributes.flatMap(({ name, type, description }) => [
    `  /** ${description.replaceAll('*/', '* /')} */`,
    `  '${name}'?: ${asWritten(type.text)} | undefined;`,
  ]);
  return [HEAD, 'export interface ShapeSplineAttributes {', ...members, '}', '', PARTS].join('\n');
}
