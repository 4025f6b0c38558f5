/** The source of images and videos: a canvas with the view in the requested size, its background and titles. */
import type { PictureSize } from '../../model/export-request.ts';
import type { Rect } from '../../viewer/types.ts';
import type { SceneController } from '../drawing/scene-controller.ts';
import { writeNames, writeTitle } from './title.ts';

export interface CaptureCanvas {
  readonly canvas: HTMLCanvasElement;
  readonly context: CanvasRenderingContext2D;
  /** Positions of the views on the canvas. */
  rects(): Rect[];
  /** Copies the current view to the canvas, with a film strip's names. `ground`: background; null for none. */
  take(ground: string | null): void;
  /** Writes the title of each of several views. */
  takeTitles(): void;
}

/**
 * Draws the viewer in a given size, on a canvas of that size, and then restores the page's view. null: size on the
 * screen. `even`: even dimensions, as video encoders need.
 */
export async function withCaptureCanvas<T>(
  scene: SceneController,
  size: PictureSize | null,
  even: boolean,
  work: (capture: CaptureCanvas) => Promise<T>,
): Promise<T> {
  const { viewer } = scene;
  const fitted = even ? evened : ({ width, height }: PictureSize): PictureSize => ({ width, height });
  await viewer.drawn();
  try {
    if (size) viewer.setPictureSize(fitted(size));
    return await work(captureCanvasOf(scene, fitted(viewer.canvas)));
  } finally {
    viewer.setPictureSize(null);
  }
}

function evened({ width, height }: PictureSize): PictureSize {
  const even = (side: number): number => Math.max(side - (side % 2), 2);
  return { width: even(width), height: even(height) };
}

function captureCanvasOf(scene: SceneController, size: PictureSize): CaptureCanvas {
  const { viewer } = scene;
  const canvas = Object.assign(document.createElement('canvas'), size);
  const context = canvas.getContext('2d', { willReadFrequently: true })!;
  // Centres the view, in case its size on the screen changes or is odd.
  const shift = (): [number, number] => [
    Math.ceil((canvas.width - viewer.canvas.width) / 2),
    Math.ceil((canvas.height - viewer.canvas.height) / 2),
  ];
  const rects = (): Rect[] => {
    const [x, y] = shift();
    return viewer.drawnRects().map((rect) => ({ ...rect, x: rect.x + x, y: rect.y + y }));
  };
  return {
    canvas,
    context,
    rects,
    take(ground) {
      context.clearRect(0, 0, canvas.width, canvas.height);
      if (ground !== null) {
        context.fillStyle = ground;
        context.fillRect(0, 0, canvas.width, canvas.height);
      }
      const [x, y] = shift();
      viewer.snapshot((view) => context.drawImage(view, x, y));
      rects().forEach((rect, view) => {
        const names = scene.filmLabels(view).map((name) => ({ ...name, x: name.x + x, y: name.y + y }));
        if (names.length > 0) writeNames(context, names, rect);
      });
    },
    takeTitles() {
      const places = rects();
      scene.labels.forEach((label, view) => {
        if (places[view]) writeTitle(context, label, places[view]);
      });
    },
  };
}
