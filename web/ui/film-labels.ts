/** Names under the shapes of film strips, as many as fit. */
import { h, setHidden, setStyle, setText } from './dom.ts';

export interface FilmLabel {
  text: string;
  /** Whether the label is that of a key, which takes precedence. */
  isKey: boolean;
  /** Position in the view, in pixels. */
  x: number;
  y: number;
}

/** Width of a letter, and space between two names, in pixels. */
const LETTER_PX = 6.6;
const GAP_PX = 6;

export function createFilmLabels(): { element: HTMLElement; update(labels: readonly FilmLabel[]): void } {
  const element = h('div', { class: 'film-labels', 'data-testid': 'film-labels', 'aria-hidden': 'true' });
  return {
    element,
    update(labels) {
      setHidden(element, labels.length === 0);
      const shown = withRoom(labels);
      while (element.children.length > shown.length) element.lastElementChild?.remove();
      shown.forEach(({ text, x, y }, index) => {
        const name = (element.children[index] ?? element.appendChild(h('span', {}))) as HTMLElement;
        setText(name, text);
        setStyle(name, 'left', `${x.toFixed(1)}px`);
        setStyle(name, 'top', `${y.toFixed(1)}px`);
      });
    },
  };
}

/** The labels that do not overlap. Of two overlapping labels, a key's stays. */
export function withRoom(labels: readonly FilmLabel[]): FilmLabel[] {
  const shown: FilmLabel[] = [];
  const apart = (a: FilmLabel, b: FilmLabel): boolean =>
    Math.abs(a.y - b.y) > 18 || Math.abs(a.x - b.x) > (LETTER_PX * (a.text.length + b.text.length)) / 2 + GAP_PX;
  for (const label of [...labels].sort((a, b) => Number(b.isKey) - Number(a.isKey)))
    if (shown.every((other) => apart(label, other))) shown.push(label);
  return shown;
}
