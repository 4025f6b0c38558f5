/** Makes <shape-spline> known to the page; without a DOM it does nothing. */
import { ShapeSplineElement } from './shape-spline.ts';

const NAME = 'shape-spline';
const known = globalThis.customElements?.get(NAME);

if (globalThis.customElements && !known) customElements.define(NAME, ShapeSplineElement);
// A name is given once: a second copy of the script, maybe of another version, is of no use.
else if (known && known !== ShapeSplineElement)
  console.warn(`<${NAME}> is already registered by another copy of shapespline; this copy is not used.`);
