/**
 * <shape-spline> in JSX and templates: React 19, Vue, Svelte. Seen from where the package has it: beside its other
 * types. Attributes and properties are those of the element's own table.
 */
import type { ShapeSplineElement, ShapeSplineProperties } from './element-class.js';

/** Properties by their own names, and attributes by theirs, as text. */
type Kebab<S extends string> = S extends `${infer A}${infer Rest}`
  ? A extends Lowercase<A>
    ? `${A}${Kebab<Rest>}`
    : `-${Lowercase<A>}${Kebab<Rest>}`
  : S;
type Attributes = { [N in keyof ShapeSplineProperties as Kebab<N>]?: ShapeSplineProperties[N] | string | boolean };
type Properties = Partial<ShapeSplineProperties> & Partial<Pick<ShapeSplineElement, 'keys'>>;
export type ShapeSplineAttributes = Omit<Attributes, keyof Properties> & Properties;

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'shape-spline': DetailedHTMLProps<HTMLAttributes<ShapeSplineElement>, ShapeSplineElement> & ShapeSplineAttributes;
    }
  }
}

declare module 'vue' {
  interface GlobalComponents {
    'shape-spline': new () => { $props: ShapeSplineAttributes };
  }
}

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'shape-spline': HTMLAttributes<ShapeSplineElement> & ShapeSplineAttributes;
  }
}
