import 'shapespline/element';
import type {} from 'shapespline/jsx';
import type { ShapeSplineElement } from 'shapespline/element-class';
import { useEffect, useRef, useState } from 'react';

/** A motion with a button of the page, which shows the time. */
export function Motion({ poses, boundary }: { poses: readonly string[]; boundary: 'natural' | 'periodic' }) {
  const shape = useRef<ShapeSplineElement>(null);
  const [time, setTime] = useState(0);
  useEffect(() => {
    const element = shape.current;
    const follow = () => setTime(element?.currentTime ?? 0);
    element?.addEventListener('timeupdate', follow);
    return () => element?.removeEventListener('timeupdate', follow);
  }, []);
  return (
    <figure>
      <shape-spline ref={shape} src={poses.join(' ')} boundary={boundary} loop="bounce" alt="A cactus bending" />
      <figcaption>
        <button type="button" onClick={() => void shape.current?.seek(0)}>
          From the start
        </button>
        <output>{time.toFixed(2)} s</output>
      </figcaption>
    </figure>
  );
}
