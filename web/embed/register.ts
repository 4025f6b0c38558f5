/** Makes <shape-spline> known to the page; without a DOM it does nothing. */
import { ShapeSplineElement } from './shape-spline.ts';

if (globalThis.customElements && !customElements.get('shape-spline'))
  customElements.define('shape-spline', ShapeSplineElement);
