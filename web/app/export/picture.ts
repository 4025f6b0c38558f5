/** The view as a PNG. */
import type { PictureSize } from '../../model/export-request.ts';
import type { SceneController } from '../drawing/scene-controller.ts';
import { commonBox, drawnBox, joined } from './crop.ts';
import type { CaptureCanvas } from './capture-canvas.ts';
import { withCaptureCanvas } from './capture-canvas.ts';
import { pageColour } from './title.ts';

export interface PictureOptions {
  /** Size of the image; null: size of the view on the screen. */
  size: PictureSize | null;
  /** Only the shape on a transparent background; otherwise with floor, on the page's background. */
  transparent: boolean;
  /** Removes the empty border. */
  crop: boolean;
}

export async function takePicture(scene: SceneController, { size, transparent, crop }: PictureOptions): Promise<Blob> {
  const ground = transparent ? null : pageColour('--stage-centre');
  try {
    return await withCaptureCanvas(scene, size, false, async (capture) => {
      // Cropping treats every pixel that is not transparent as drawn.
      scene.setFloorless(transparent || crop);
      const box = crop ? boxOf(capture) : null;
      scene.setFloorless(transparent);
      capture.take(ground);
      if (box) return await pngOf(joined(capture.canvas, capture.rects(), box, scene.labels, ground));
      capture.takeTitles();
      return await pngOf(capture.canvas);
    });
  } finally {
    scene.setFloorless(false);
  }
}

function boxOf(capture: CaptureCanvas): ReturnType<typeof commonBox> {
  capture.take(null);
  const rects = capture.rects();
  const boxes = rects.map(({ x, y, width, height }) =>
    drawnBox(capture.context.getImageData(Math.round(x), Math.round(y), Math.round(width), Math.round(height))),
  );
  return commonBox(boxes, { width: Math.round(rects[0]!.width), height: Math.round(rects[0]!.height) });
}

function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error('The browser could not create an image of this size. Choose a smaller size.'));
    }, 'image/png');
  });
}
