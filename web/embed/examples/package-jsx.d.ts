/** What the package's entry `jsx` declares, made when it is built, as far as the example needs it. */
import type { HTMLAttributes, RefAttributes } from 'react';
import type { ShapeSplineElement } from '../shape-spline.ts';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'shape-spline': HTMLAttributes<ShapeSplineElement> &
        RefAttributes<ShapeSplineElement> & { src?: string; boundary?: string; loop?: string; alt?: string };
    }
  }
}
