/** Declarations for this example, from the package's entry `jsx`, which the build makes. */
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
