import type { ShapeSplineElement } from '../shape-spline.ts';

/** The time in the motion follows the scroll position in the window. */
export function followScroll(shape: ShapeSplineElement): void {
  const follow = () => {
    const { top, height } = shape.getBoundingClientRect();
    const share = 1 - (top + height) / (innerHeight + height);
    const { duration } = shape;
    if (duration > 0 && share >= 0 && share <= 1) shape.currentTime = share * duration;
  };
  shape.addEventListener('load', follow);
  addEventListener('scroll', follow, { passive: true });
}
