/** Defines <shape-spline> in the page; does nothing without a DOM. */
import { ShapeSplineElement } from './shape-spline.ts';

const NAME = 'shape-spline';
const known = globalThis.customElements?.get(NAME);

if (globalThis.customElements && !known) customElements.define(NAME, ShapeSplineElement);
// A name can be defined only once, so a second copy of the script, possibly of another version, has no effect.
else if (known && known !== ShapeSplineElement)
  console.warn(`<${NAME}> is already registered by another copy of shapespline; this copy is not used.`);
