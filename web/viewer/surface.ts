/** Where pictures are drawn, and where they are seen. */
import { Vector2, WebGLRenderer } from 'three';

export interface Surface {
  readonly renderer: WebGLRenderer;
  /** What is seen on the page, and what pointers act on. */
  readonly canvas: HTMLCanvasElement;
  /** In CSS pixels, each of which is `ratio` wide; `styled`: the canvas takes as much room on the page. */
  setSize(width: number, height: number, ratio: number, styled: boolean): void;
  /** Before and after the views of a picture are drawn, from the lower left corner of the renderer's canvas. */
  begin(): void;
  end(): void;
  dispose(): void;
}

/** Throws where the browser has no WebGL 2. */
export function newRenderer(): WebGLRenderer {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'high-performance' });
  // Each of the two waits for all that the graphics card has been given: asking for the log of every program while it
  // is made, and for an extension in the middle of the first picture instead of before it.
  renderer.debug.checkShaderErrors = false;
  renderer.capabilities.getMaxAnisotropy();
  renderer.setClearColor(0x000000, 0);
  renderer.autoClear = false;
  return renderer;
}

/** A renderer of its own: what it draws is seen as it is. */
export function ownSurface(): Surface {
  const renderer = newRenderer();
  const canvas = renderer.domElement;
  return {
    renderer,
    canvas,
    setSize(width, height, ratio, styled) {
      if (styled) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
      // A canvas is made anew by every setting of its size, even to what it has.
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
