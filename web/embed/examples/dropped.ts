import type { ShapeSplineElement } from '../shape-spline.ts';

/** Shows files that the user chooses or drops. They stay on the user's machine. */
export function takeFiles(input: HTMLInputElement, shape: ShapeSplineElement): void {
  const take = (files: FileList | null | undefined) => {
    if (files && files.length > 0) shape.keys = [...files];
  };
  input.addEventListener('change', () => take(input.files));
  shape.addEventListener('dragover', (event: DragEvent) => event.preventDefault());
  shape.addEventListener('drop', (event: DragEvent) => {
    event.preventDefault();
    take(event.dataTransfer?.files);
  });
}
