/** Small images of shapes, drawn off screen, so the visible canvas does not change. */
import { Color, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderTarget } from 'three';
import type { WebGLRenderer } from 'three';
import { FIELD_OF_VIEW, NO_INSETS, directionOf, fittedPose, setLens } from './fit.ts';
import type { Extent } from './fit.ts';
import type { Shape } from './shape.ts';
import type { Studio } from './studio.ts';

const SAMPLES = 4;
/** A shape smaller than this share of the motion's extent would be a speck, so it fills the image. */
const TRAVELS = 0.5;

/** The extent of an image of a shape whose motion covers `whole`. */
export const pictureExtent = (own: Extent, whole: Extent): Extent =>
  own.radius < TRAVELS * whole.radius ? own : whole;

export class Thumbnails {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW);
  private extent: Extent | null = null;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly studio: Studio,
  ) {}

  /** Sets the common view for images of a new import, except shapes that travel. */
  setExtent(extent: Extent): void {
    this.extent = extent;
  }

  /** A data URL; empty before the first import. `own`: the shape's extent; width and height in CSS pixels. */
  draw(shape: Shape, own: Extent, width: number, height: number): string {
    return this.canvas(shape, own, width, height)?.toDataURL('image/png') ?? '';
  }

  /** Null before the first import, or if the browser has no 2D context. */
  private canvas(shape: Shape, own: Extent, width: number, height: number): HTMLCanvasElement | null {
    if (!this.extent) return null;
    const extent = pictureExtent(own, this.extent);
    const ratio = this.renderer.getPixelRatio();
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    this.placeCamera(extent, w / h);
    this.scene.add(shape.object);
    const target = new WebGLRenderTarget(w, h, { colorSpace: SRGBColorSpace, samples: SAMPLES });
    const pixels = new Uint8ClampedArray(4 * w * h);
    this.renderInto(target);
    this.renderer.readRenderTargetPixels(target, 0, 0, w, h, pixels);
    target.dispose();
    shape.object.removeFromParent();
    return canvasOf(pixels, w, h);
  }

  private placeCamera(extent: Extent, aspect: number): void {
    const pose = fittedPose(directionOf('home'), extent, aspect, NO_INSETS);
    const target = new Vector3(...pose.target);
    this.camera.position.set(...pose.position);
    this.camera.lookAt(target);
    setLens(this.camera, target, extent.radius, aspect, NO_INSETS);
    this.studio.follow(this.camera);
  }

  /** Renders on a transparent background, whatever is behind the shape on the canvas. */
  private renderInto(target: WebGLRenderTarget): void {
    const { renderer } = this;
    const ground = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
    renderer.setClearColor(ground, alpha);
  }
}

/**
 * Input rows run from bottom to top, in sRGB, premultiplied by alpha in linear light, as blending and multisampling
 * produce them.
 */
function canvasOf(pixels: Uint8ClampedArray<ArrayBuffer>, width: number, height: number): HTMLCanvasElement | null {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  if (!context) return null;
  const image = context.createImageData(width, height);
  for (let row = 0; row < height; row += 1)
    image.data.set(pixels.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
  divideByAlpha(image.data);
  context.putImageData(image, 0, 0);
  return canvas;
}

function divideByAlpha(pixels: Uint8ClampedArray): void {
  const colour = new Color();
  const parts = { r: 0, g: 0, b: 0 };
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3]! / 255;
    if (alpha === 0 || alpha === 1) continue;
    colour.setRGB(pixels[i]! / 255, pixels[i + 1]! / 255, pixels[i + 2]! / 255, SRGBColorSpace);
    colour.multiplyScalar(1 / alpha).getRGB(parts, SRGBColorSpace);
    pixels.set([255 * parts.r, 255 * parts.g, 255 * parts.b], i);
  }
}
