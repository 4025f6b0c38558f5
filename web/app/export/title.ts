/** Titles over an image's views, in the page's font, scaled to the image. */
import type { Rect } from '../../viewer/types.ts';

export interface Title {
  title: string;
  /** Measures; empty if unknown. */
  detail: string;
}

/** Text height as a share of a view's smaller side. */
const LETTERS = 1 / 30;
const MIN_LETTERS = 12;
const LINE = 1.35;

/** Text height over a view. */
function lettersOf({ width, height }: Pick<Rect, 'width' | 'height'>): number {
  return Math.max(Math.round(LETTERS * Math.min(width, height)), MIN_LETTERS);
}

/** Height of a title with its measures and padding. */
export function titleHeight(rect: Pick<Rect, 'width' | 'height'>, { detail }: Title): number {
  return Math.ceil(lettersOf(rect) * LINE * (detail === '' ? 1.5 : 2.5));
}

/** Centred at the top of a view, no wider than the view. */
export function writeTitle(context: CanvasRenderingContext2D, { title, detail }: Title, rect: Rect): void {
  const letters = lettersOf(rect);
  const family = getComputedStyle(document.body).fontFamily;
  const middle = rect.x + rect.width / 2;
  const most = 0.96 * rect.width;
  context.save();
  context.textAlign = 'center';
  context.textBaseline = 'top';
  context.fillStyle = pageColour('--text');
  context.font = `600 ${letters}px ${family}`;
  context.fillText(title, middle, rect.y + 0.4 * letters, most);
  context.fillStyle = pageColour('--muted');
  context.font = `400 ${Math.round(0.85 * letters)}px ${family}`;
  context.fillText(detail, middle, rect.y + (0.4 + LINE) * letters, most);
  context.restore();
}

/** Names under the shapes of a film strip. All have the largest size that fits the narrowest gap. */
export function writeNames(
  context: CanvasRenderingContext2D,
  names: readonly { text: string; x: number; y: number }[],
  view: Rect,
): void {
  const rooms = names.slice(1).map(({ x }, i) => Math.abs(x - names[i]!.x));
  const longest = Math.max(...names.map(({ text }) => text.length), 1);
  const letters = Math.round(Math.min(0.8 * lettersOf(view), (1.5 * Math.min(...rooms)) / longest));
  context.save();
  context.textAlign = 'center';
  context.textBaseline = 'top';
  context.fillStyle = pageColour('--text');
  context.font = `400 ${letters}px ${getComputedStyle(document.body).fontFamily}`;
  for (const { text, x, y } of names) context.fillText(text, x, y + 0.6 * letters);
  context.restore();
}

/** A colour from the page's style sheet, in the current theme. */
export function pageColour(name: string): string {
  const probe = document.createElement('span');
  probe.style.color = `var(${name})`;
  document.body.append(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
