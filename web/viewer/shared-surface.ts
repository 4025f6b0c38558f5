/**
 * One renderer for all element views on a page, because a browser allows about sixteen contexts. Each image is drawn
 * into a common off-page canvas and copied to the element's canvas before the next is drawn.
 */
import type { WebGLRenderer } from 'three';
import { newRenderer } from './surface.ts';
import type { Surface } from './surface.ts';

/** Created with the first image and kept, because creating it takes longer than drawing. */
let shared: { renderer: WebGLRenderer; width: number; height: number; ratio: number } | null = null;

/** Throws if the browser has no WebGL 2. */
export function sharedSurface(): Surface {
  shared ??= { renderer: newRenderer(), width: 0, height: 0, ratio: 0 };
  const all = shared;
  const { renderer } = all;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d')!;
  let size = { width: 1, height: 1, ratio: 1 };

  /** Enlarges the common canvas to the largest image so far. */
  const makeRoom = (): void => {
    const { width, height, ratio } = size;
    if (width <= all.width && height <= all.height && ratio === all.ratio) return;
    all.width = Math.max(width, all.width);
    all.height = Math.max(height, all.height);
    all.ratio = ratio;
    renderer.setPixelRatio(ratio);
    renderer.setSize(all.width, all.height, false);
  };

  return {
    renderer,
    canvas,
    setSize(width, height, ratio, styled) {
      size = { width, height, ratio };
      const pixels = [Math.floor(width * ratio), Math.floor(height * ratio)] as const;
      if (canvas.width !== pixels[0] || canvas.height !== pixels[1]) [canvas.width, canvas.height] = pixels;
      if (styled) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
    },
    begin: makeRoom,
    end() {
      const { width, height } = canvas;
      // The last image stays until the context is restored.
      if (renderer.getContext().isContextLost()) return;
      context.clearRect(0, 0, width, height);
      const top = renderer.domElement.height - height;
      context.drawImage(renderer.domElement, 0, top, width, height, 0, 0, width, height);
    },
    dispose: () => canvas.remove(),
  };
}
