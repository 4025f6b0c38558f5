/** Tools of every figure: enlarge, show values, save. */
import type { Plot } from '../../model/state.ts';
import { button } from '../../ui/controls.ts';
import { h, setAttribute, setText } from '../../ui/dom.ts';
import type { FigureFilesOptions } from './figure-files.ts';

export interface FigureEvents {
  /** Enlarges this plot to fill the screen. */
  onEnlarge(plot: Plot): void;
  onError(error: unknown): void;
}

export type FigureToolsOptions = FigureFilesOptions & FigureEvents;

/** Adds the enlarge button, and values and files, which are loaded on first use. Call the result after each redraw. */
export function addFigureTools(figure: HTMLElement, options: FigureToolsOptions): () => void {
  const { plot, title, onEnlarge, onError } = options;
  figure.id = `plot-${plot}`;
  setAttribute(figure, 'data-plot', plot);
  const enlarge = button({
    label: 'Enlarge',
    testId: `enlarge-${plot}`,
    icon: 'enlarge',
    shortcut: 'A',
    onClick: () => onEnlarge(plot),
  });
  figure.querySelector('figcaption')?.append(enlarge);
  const content = h('div', {});
  const said = h('span', { class: 'visually-hidden' }, ` of ${title}`);
  const details = h(
    'details',
    { class: 'details values', 'data-testid': `${plot}-values` },
    h('summary', {}, 'Values and files', said),
    content,
  );
  figure.append(details);
  let fill: (() => void) | null = null;
  const load = async (): Promise<void> => {
    const { createFigureFiles } = await import('./figure-files.ts');
    const files = createFigureFiles(figure, options);
    fill ??= files.fill;
    if (content.childElementCount === 0) content.append(files.element);
    fill();
  };
  details.addEventListener('toggle', () => {
    if (!details.open) return;
    if (fill) return fill();
    load().catch((error: unknown) => {
      setText(content, 'The values could not be loaded.');
      onError(error);
    });
  });
  return () => {
    setAttribute(figure, 'data-gone', false);
    if (details.open) fill?.();
  };
}
