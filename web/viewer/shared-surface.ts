/**
 * One renderer for all pictures of a page: a browser gives it sixteen contexts at most. Each picture is drawn into the
 * same canvas, which is on no page, and copied to a canvas of its own before the next one is drawn.
 */
import type { WebGLRenderer } from 'three';
import { newRenderer } from './surface.ts';
import type { Surface } from './surface.ts';

/** Made with the first picture; it stays, as making one takes longer than drawing. */
let shared: { renderer: WebGLRenderer; width: number; height: number; ratio: number } | null = null;

/** Throws where the browser has no WebGL 2. */
export function sharedSurface(): Surface {
  shared ??= { renderer: newRenderer(), width: 0, height: 0, ratio: 0 };
  const all = shared;
  const { renderer } = all;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d')!;
  let size = { width: 1, height: 1, ratio: 1 };

  /** Large enough for the largest picture so far. */
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
      // The last picture stays until there is another one.
      if (renderer.getContext().isContextLost()) return;
      context.clearRect(0, 0, width, height);
      const top = renderer.domElement.height - height;
      context.drawImage(renderer.domElement, 0, top, width, height, 0, 0, width, height);
    },
    dispose: () => canvas.remove(),
  };
}
