/** A plot as a file: an SVG that needs no style sheet, the same as a PNG, and numbers as CSV. */

/** What the style sheet says of a plot's parts. */
const STYLED = [
  ...['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'stroke-linejoin'],
  ...['opacity', 'paint-order', 'font-family', 'font-size', 'font-weight', 'text-anchor'],
] as const;

/** What is written above a picture that stands alone. */
export interface Heading {
  title: string;
  unit?: string;
}

/**
 * The picture as it is on the page, on the page's ground, each part with its own colours, under its title and the names
 * of its curves.
 */
export function svgOf(element: SVGSVGElement, heading: Heading): string {
  return new XMLSerializer().serializeToString(standing(element, heading));
}

/** Errors: where the browser cannot draw the picture. */
export async function pngOf(element: SVGSVGElement, heading: Heading, scale = 3): Promise<Blob> {
  const picture = standing(element, heading);
  const size = (name: string): number => scale * Number(picture.getAttribute(name));
  const [width, height] = [size('width'), size('height')];
  const source = new XMLSerializer().serializeToString(picture);
  const url = URL.createObjectURL(new Blob([source], { type: 'image/svg+xml' }));
  try {
    const image = new Image(width, height);
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [width, height];
    canvas.getContext('2d')!.drawImage(image, 0, 0, width, height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('The picture could not be made.'))),
        'image/png',
      );
    });
  } finally {
    URL.revokeObjectURL(url);
  }
}

function standing(element: SVGSVGElement, heading: Heading): SVGSVGElement {
  const copy = plain(element);
  const { width, height } = element.viewBox.baseVal;
  const { head, tall } = headed(element, heading, width);
  head.setAttribute('transform', `translate(0 ${-tall})`);
  const ground = part('rect', { y: -tall, width, height: height + tall, fill: groundOf(element) });
  copy.prepend(ground, head);
  const size = { viewBox: `0 ${-tall} ${width} ${height + tall}`, width, height: height + tall };
  for (const [name, value] of Object.entries(size)) copy.setAttribute(name, String(value));
  return copy;
}

/** A copy that needs no style sheet. */
function plain(element: SVGSVGElement): SVGSVGElement {
  const copy = element.cloneNode(true) as SVGSVGElement;
  const from = [element, ...element.querySelectorAll('*')];
  const to = [copy, ...copy.querySelectorAll('*')];
  const hidden: Element[] = [];
  from.forEach((one, index) => {
    const target = to[index]!;
    if (getComputedStyle(one).display === 'none') hidden.push(target);
    if (one.localName !== 'title') for (const [name, value] of styleOf(one, STYLED)) target.setAttribute(name, value);
    for (const { name } of [...target.attributes])
      if (/^(class|tabindex|role|data-.*|aria-.*)$/.test(name)) target.removeAttribute(name);
  });
  for (const one of hidden) one.remove();
  return copy;
}

const LINE = ['stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity'] as const;
const LARGE = 12;
const SMALL = 9;
const MARGIN = 8;
const LEADING = 14;
/** For a piece of a curve, and the space after it. */
const SAMPLE = 22;
/** Of a letter, of its height: there is nothing to measure text with in a file. */
const LETTER = 0.62;

/** Title and names of the curves, from the upper edge down; how tall they are. */
function headed(element: SVGSVGElement, { title, unit }: Heading, width: number): { head: SVGElement; tall: number } {
  const { color, fontFamily } = getComputedStyle(element);
  const head = part('g', { 'font-family': fontFamily, fill: plainColour(color).colour });
  const say = (x: number, y: number, size: number, content: string): void => {
    const text = part('text', { x, y, 'font-size': `${size}px` });
    text.textContent = content;
    head.append(text);
  };
  let [x, y] = [MARGIN, MARGIN + LARGE];
  say(x, y, LARGE, title);
  for (const line of unit ? wrapped(unit, width) : []) {
    y += LEADING;
    say(x, y, SMALL, line);
  }
  for (const [index, { name, line }] of namedCurves(element).entries()) {
    const long = SAMPLE + name.length * SMALL * LETTER + MARGIN;
    if (index === 0 || x + long > width) [x, y] = [MARGIN, y + LEADING];
    head.append(part('line', { x1: x, x2: x + SAMPLE - 4, y1: y - SMALL / 3, y2: y - SMALL / 3, ...line }));
    say(x + SAMPLE, y, SMALL, name);
    x += long;
  }
  return { head, tall: y + MARGIN };
}

/** Each name once, with the look of its first curve. */
function namedCurves(element: SVGSVGElement): { name: string; line: Record<string, string> }[] {
  const first = new Map<string, Element>();
  for (const curve of element.querySelectorAll('.curve, .level')) {
    const name = curve.querySelector('title')?.textContent;
    if (name && !first.has(name)) first.set(name, curve);
  }
  return [...first].map(([name, curve]) => ({ name, line: Object.fromEntries(styleOf(curve, LINE)) }));
}

function wrapped(text: string, width: number): string[] {
  const most = Math.floor((width - 2 * MARGIN) / (SMALL * LETTER));
  const lines = [''];
  for (const word of text.split(' ')) {
    if (lines.at(-1)!.length + word.length >= most) lines.push('');
    lines.push(`${lines.pop()!} ${word}`.trim());
  }
  return lines;
}

/** What the style sheet says of an element, colours as any program reads them. */
function styleOf(element: Element, names: readonly string[]): [string, string][] {
  const style = getComputedStyle(element);
  return names.map((name) => {
    const value = style.getPropertyValue(name);
    const paint = /^(fill|stroke)(-opacity)?$/.exec(name);
    if (!paint) return [name, value];
    const { colour, opacity } = plainColour(style.getPropertyValue(paint[1]!));
    return [name, paint[2] ? String(Number((Number(value) * opacity).toPrecision(3))) : colour];
  });
}

function part(tag: 'g' | 'rect' | 'text' | 'line', attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/** A computed colour as any program reads it: what is mixed or transparent is written in newer ways by browsers. */
export function plainColour(computed: string): { colour: string; opacity: number } {
  const [kind = '', inside = ''] = /^(color\(srgb|rgba?\()(.*)\)$/.exec(computed)?.slice(1) ?? [];
  const numbers = (inside.match(/[\d.e-]+/g) ?? []).map(Number);
  const [r, g, b, opacity = 1] = numbers;
  if (r === undefined || g === undefined || b === undefined) return { colour: computed, opacity: 1 };
  const channel = (value: number): number => Math.round(kind.startsWith('color') ? 255 * value : value);
  return { colour: `rgb(${[r, g, b].map(channel).join(', ')})`, opacity };
}

/** Rows of numbers under their names; what is not finite is left empty. */
export function csvOf(names: readonly string[], rows: readonly (readonly number[])[]): string {
  const cell = (value: number): string => (Number.isFinite(value) ? String(Number(value.toPrecision(9))) : '');
  return [names.join(','), ...rows.map((row) => row.map(cell).join(',')), ''].join('\n');
}

/** The first ground behind the element that can be seen. */
function groundOf(element: Element): string {
  for (let at: Element | null = element; at; at = at.parentElement) {
    const { backgroundColor } = getComputedStyle(at);
    if (!/^(transparent|rgba\(0, 0, 0, 0\))$/.test(backgroundColor)) return backgroundColor;
  }
  return '#ffffff';
}
