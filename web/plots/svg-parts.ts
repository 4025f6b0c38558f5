/** Basic parts of a plot. */
import { path } from './scale.ts';

export function make<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number>,
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, typeof value === 'number' ? String(Number(value.toFixed(2))) : value);
  }
  return element;
}

/** A tooltip shows its name; a file's legend shows it with a sample. */
export function namedCurve(
  name: string,
  style: string,
  points: readonly (readonly [number, number])[],
): SVGPathElement {
  return named(name, make('path', { class: `curve ${style}`, d: path(points) }));
}

export function named<E extends SVGElement>(name: string, element: E): E {
  const title = make('title', {});
  title.textContent = name;
  element.append(title);
  return element;
}

export function text(style: string, x: number, y: number, content: string): SVGTextElement {
  const element = make('text', { class: style, x, y });
  element.textContent = content;
  return element;
}
