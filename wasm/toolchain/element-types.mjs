// Types of the custom element for TypeScript markup, generated from its manifest.

/** Declares the type of `document.querySelector('shape-spline')`. */
export const elementTypes = `import type { ShapeSplineElement } from './element-class.js';

declare global {
  interface HTMLElementTagNameMap {
    'shape-spline': ShapeSplineElement;
  }
}

export {};
`;

/** Types common to all frameworks: attributes, properties and listeners. */
const OWN = `/** Properties that have no attribute of the same name. */
export type ShapeSplineExtras = {
  [N in Exclude<keyof ShapeSplineProperties, keyof ShapeSplineAttributes>]?: ShapeSplineProperties[N] | undefined;
} & {
  /** Takes precedence over src: URLs, Blobs or ArrayBuffers of one key each, or of all. */
  keys?: readonly KeySource[] | null | undefined;
};

/** Listeners, by the name that a framework gives to one of an event. */
export type ShapeSplineListeners<Before extends string = 'on'> = {
  [N in keyof ShapeSplineEventMap as \`\${Before}\${N}\`]?: ((event: ShapeSplineEventMap[N]) => void) | undefined;
};
`;

const FROM_ATTRIBUTES = `import type { ShapeSplineAttributes, ShapeSplineExtras, ShapeSplineListeners } from './attributes.js';`;
const SHARED_NAMES = `export type { ShapeSplineAttributes, ShapeSplineExtras, ShapeSplineListeners } from './attributes.js';`;

/**
 * Types for each framework, which augment its own types. Each is a separate entry, because an augmented module must
 * exist. React 19 and Svelte 5 listen by the event's name (`onseeked`), Vue by `@seeked`, which its types call
 * `onSeeked`.
 */
export const FRAMEWORKS = {
  jsx: `import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type { ShapeSplineElement } from './element-class.js';
${FROM_ATTRIBUTES}
${SHARED_NAMES}

export type ShapeSplineProps = DetailedHTMLProps<HTMLAttributes<ShapeSplineElement>, ShapeSplineElement> &
  ShapeSplineAttributes &
  ShapeSplineExtras &
  ShapeSplineListeners;

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'shape-spline': ShapeSplineProps;
    }
  }
}
`,
  vue: `import type { HTMLAttributes, PublicProps } from 'vue';
import type { ShapeSplineElement, ShapeSplineEventMap, ShapeSplineProperties } from './element-class.js';
import type { ShapeSplineAttributes, ShapeSplineExtras } from './attributes.js';
export type { ShapeSplineAttributes, ShapeSplineExtras } from './attributes.js';

/** Templates know \`key-times\` as \`keyTimes\`, too. */
type Camel<S extends string> = S extends \`\${infer A}-\${infer B}\` ? \`\${A}\${Capitalize<Camel<B>>}\` : S;
type InTemplates = {
  [A in keyof ShapeSplineAttributes as Camel<A>]?:
    | ShapeSplineAttributes[A]
    | (Camel<A> extends keyof ShapeSplineProperties ? ShapeSplineProperties[Camel<A>] : never);
};
type Listeners = {
  [N in keyof ShapeSplineEventMap as \`on\${Capitalize<N>}\`]?: ((event: ShapeSplineEventMap[N]) => void) | undefined;
};

export type ShapeSplineProps = Omit<HTMLAttributes, keyof Listeners> &
  PublicProps &
  ShapeSplineAttributes &
  Omit<ShapeSplineExtras, keyof InTemplates> &
  InTemplates &
  Listeners;

declare module 'vue' {
  interface GlobalComponents {
    'shape-spline': new () => ShapeSplineElement & { $props: ShapeSplineProps };
  }
}
`,
  svelte: `import type { HTMLAttributes } from 'svelte/elements';
import type { ShapeSplineElement } from './element-class.js';
${FROM_ATTRIBUTES}
${SHARED_NAMES}

type Listeners = ShapeSplineListeners & ShapeSplineListeners<'on:'>;

export type ShapeSplineProps = Omit<HTMLAttributes<ShapeSplineElement>, keyof Listeners> &
  ShapeSplineAttributes &
  ShapeSplineExtras &
  Listeners;

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'shape-spline': ShapeSplineProps;
  }
}
`,
};

// An attribute is text; its value can also have its own type.
const asWritten = (type) => {
  if (type === 'boolean') return "boolean | '' | 'true' | 'false'";
  if (type.startsWith('number')) return 'number | string';
  return type === 'string' || type.includes('[]') ? 'string' : type;
};

/** `attributes.d.ts`, generated from the element's manifest. */
export function attributeTypes(manifest) {
  const { attributes } = manifest.modules[0].declarations[0];
  const members = attributes.flatMap(({ name, type, description }) => [
    `  /** ${description.replaceAll('*/', '* /')} */`,
    `  '${name}'?: ${asWritten(type.text)} | undefined;`,
  ]);
  const head = "import type { KeySource, ShapeSplineEventMap, ShapeSplineProperties } from './element-class.js';";
  return [head, '', 'export interface ShapeSplineAttributes {', ...members, '}', '', OWN].join('\n');
}
