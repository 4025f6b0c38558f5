/** Canvases for drawing and display. */
import { Vector2, WebGLRenderer } from 'three';

export interface Surface {
  readonly renderer: WebGLRenderer;
  /** The visible canvas, which receives pointer events. */
  readonly canvas: HTMLCanvasElement;
  /** Size in CSS pixels of `ratio` device pixels each; `styled`: also sets the size on the page. */
  setSize(width: number, height: number, ratio: number, styled: boolean): void;
  /** Called before and after the views of an image are drawn, from the lower left corner of the renderer's canvas. */
  begin(): void;
  end(): void;
  dispose(): void;
}

/** Throws if the browser has no WebGL 2. */
export function newRenderer(): WebGLRenderer {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'high-performance' });
  // Both calls would wait for the graphics card. The first reads every program's log during compilation. The second
  // requests an extension during the first image.
  renderer.debug.checkShaderErrors = false;
  renderer.capabilities.getMaxAnisotropy();
  renderer.setClearColor(0x000000, 0);
  renderer.autoClear = false;
  return renderer;
}

/** A surface with its own renderer, displayed directly. */
export function ownSurface(): Surface {
  const renderer = newRenderer();
  const canvas = renderer.domElement;
  return {
    renderer,
    canvas,
    setSize(width, height, ratio, styled) {
      if (styled) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
      // Setting its size recreates a canvas, even if the size does not change.
      const before = renderer.getSize(new Vector2());
      if (before.x !== width || before.y !== height || renderer.getPixelRatio() !== ratio)
        renderer.setDrawingBufferSize(width, height, ratio);
    },
    begin: () => undefined,
    end: () => undefined,
    dispose() {
      renderer.dispose();
      canvas.remove();
    },
  };
}
