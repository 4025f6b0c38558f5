/** The element and the engine in one file, for `<script type="module" src>`. */
import './register.ts';

export * from '../engine/browser.ts';
export { ShapeSplineElement } from './shape-spline.ts';
