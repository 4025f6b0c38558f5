/** A plot as a file: a self-contained SVG, a PNG, and numbers as CSV. */

/** Styles to copy from the style sheet. */
const STYLED = [
  ...['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'stroke-linejoin'],
  ...['opacity', 'paint-order', 'font-family', 'font-size', 'font-weight', 'text-anchor'],
] as const;

/** Axis titles with units. */
export interface Axes {
  x: string;
  y: string;
}

/** Text around a standalone plot. */
export interface Heading extends Partial<Axes> {
  title: string;
  unit?: string;
}

/** Small plots have the width of a paper's column, so type has its intended size. */
const COLUMN_MM = 85;
const PAGE_MM = 170;
/** Wider plots fill the page. */
const COLUMN_UNITS = 400;
/** Resolution of a PNG, as journals require for drawings. */
const DPI = 600;
/** Fonts that other programs have. */
const FONT = 'Arial, Helvetica, sans-serif';
/** Elements that exist only on the page: cursor, read-out, handles. */
const LIVE = '.cursor, .read-out, .now-mark, .plane-point, .end-handle, .drawn';

/**
 * The plot in the page's colours, in millimetres, with title, legend and axis titles, but without interactive elements.
 */
export function svgOf(element: SVGSVGElement, heading: Heading): string {
  return new XMLSerializer().serializeToString(standing(element, heading));
}

/** Throws if the browser cannot draw the plot. */
export async function pngOf(element: SVGSVGElement, heading: Heading): Promise<Blob> {
  const picture = standing(element, heading);
  const size = (name: string): number => Math.round((DPI / 25.4) * parseFloat(picture.getAttribute(name)!));
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
        (blob) => (blob ? resolve(blob) : reject(new Error('The image could not be created.'))),
        'image/png',
      );
    });
  } finally {
    URL.revokeObjectURL(url);
  }
}

function standing(element: SVGSVGElement, heading: Heading): SVGSVGElement {
  const { copy, box } = plain(element);
  const { x, y, ...above } = heading;
  const large = typeOf(element) / TYPE;
  const axes = axisTitles({ x, y }, box, element);
  const [left, right] = [box.left - (y ? LEADING * large : 0), box.right];
  const bottom = box.bottom + (x ? LEADING * large : 0);
  const { head, tall: lines } = headed(element, above, (right - left) / large);
  const tall = lines * large;
  head.setAttribute('transform', `translate(${left} ${-tall}) scale(${large})`);
  const [width, height] = [right - left, bottom + tall].map((size) => Number(size.toFixed(2))) as [number, number];
  const ground = part('rect', { x: left, y: -tall, width, height, fill: groundOf(element.parentElement) });
  copy.prepend(ground, head, axes);
  const mm = width > COLUMN_UNITS ? PAGE_MM : COLUMN_MM;
  const size = { width: `${mm}mm`, height: `${((mm * height) / width).toFixed(2)}mm` };
  for (const [name, value] of Object.entries({ viewBox: `${left} ${-tall} ${width} ${height}`, ...size }))
    copy.setAttribute(name, value);
  return copy;
}

/** A box in plot units. */
interface Box {
  left: number;
  right: number;
  bottom: number;
}

/** Axis titles beside and below the tick labels. */
function axisTitles({ x = '', y = '' }: Partial<Axes>, { left, bottom }: Box, element: SVGSVGElement): SVGElement {
  const { width, height } = element.viewBox.baseVal;
  const { color } = getComputedStyle(element);
  const size = (SMALL * typeOf(element)) / TYPE;
  const look = { 'font-family': FONT, 'font-size': `${size}px`, 'text-anchor': 'middle' };
  const group = part('g', { ...look, fill: plainColour(color).colour });
  const along = part('text', { x: width / 2, y: bottom + 1.25 * size });
  along.textContent = x;
  const up = part('text', { transform: `translate(${left - MARGIN / 2} ${height / 2}) rotate(-90)` });
  up.textContent = y;
  group.append(...(x ? [along] : []), ...(y ? [up] : []));
  return group;
}

/** Font size of the tick labels. */
function typeOf(element: SVGSVGElement): number {
  const tick = element.querySelector('text');
  return tick ? parseFloat(getComputedStyle(tick).fontSize) : TYPE;
}

/** A self-contained copy, and its bounding box including tick labels. */
function plain(element: SVGSVGElement): { copy: SVGSVGElement; box: Box } {
  const copy = element.cloneNode(true) as SVGSVGElement;
  for (const live of copy.querySelectorAll(LIVE)) live.remove();
  for (const name of ['lit', 'selected'])
    for (const one of copy.querySelectorAll(`.${name}`)) one.classList.remove(name);
  copy.classList.add('filed');
  // The copy is inserted into the page to compute its styles and sizes. Nothing is painted during this time.
  element.after(copy);
  const all = [copy, ...copy.querySelectorAll('*')];
  const hidden = all.filter((one) => getComputedStyle(one).display === 'none');
  const styles = all.map((one) => (one.localName === 'title' ? [] : styleOf(one, STYLED)));
  all.forEach((one, index) => {
    for (const [name, value] of styles[index]!) one.setAttribute(name, name === 'font-family' ? FONT : value);
  });
  const ticks = [...copy.querySelectorAll<SVGTextElement>('.tick-x, .tick-y')].filter((one) => !hidden.includes(one));
  const boxes = ticks.map((one) => one.getBBox());
  const { width, height } = element.viewBox.baseVal;
  const box = {
    left: Math.floor(Math.min(0, ...boxes.map(({ x }) => x - 1))),
    right: Math.ceil(Math.max(width, ...boxes.map((one) => one.x + one.width + 1))),
    bottom: Math.ceil(Math.max(height, ...boxes.map((one) => one.y + one.height))),
  };
  copy.remove();
  for (const one of hidden) one.remove();
  for (const one of all)
    for (const { name } of [...one.attributes])
      if (/^(class|style|tabindex|role|data-.*|aria-.*)$/.test(name)) one.removeAttribute(name);
  return { copy, box };
}

const LINE = ['stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity'] as const;
/** Font size of ticks that matches the sizes of the other text. */
const TYPE = 10;
const LARGE = 12;
const SMALL = 9;
const MARGIN = 8;
const LEADING = 14;
/** Width of a line sample, including the following space. */
const SAMPLE = 22;
/** Mean width of a letter relative to its height, because a file cannot measure text. */
const LETTER = 0.62;

/** Title and legend from the top down, and their height. */
function headed(element: SVGSVGElement, { title, unit }: Heading, width: number): { head: SVGElement; tall: number } {
  const { color } = getComputedStyle(element);
  const head = part('g', { 'font-family': FONT, fill: plainColour(color).colour });
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

/** The curves' names without duplicates, each with the look of its first curve. */
function namedCurves(element: SVGSVGElement): { name: string; line: Record<string, string> }[] {
  const first = new Map<string, Element>();
  for (const curve of element.querySelectorAll('.curve:not(.further, .extrapolated), .level')) {
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

/** Computed styles of an element, with colours in a common format. */
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

/** A computed colour in a common format, because browsers use newer notations for mixed or transparent colours. */
export function plainColour(computed: string): { colour: string; opacity: number } {
  const [kind = '', inside = ''] = /^(color\(srgb|rgba?\()(.*)\)$/.exec(computed)?.slice(1) ?? [];
  const numbers = (inside.match(/[\d.e-]+/g) ?? []).map(Number);
  const [r, g, b, opacity = 1] = numbers;
  if (r === undefined || g === undefined || b === undefined) return { colour: computed, opacity: 1 };
  const channel = (value: number): number => Math.round(kind.startsWith('color') ? 255 * value : value);
  return { colour: `rgb(${[r, g, b].map(channel).join(', ')})`, opacity };
}

/** Rows of numbers under a header; values that are not finite are empty. */
export function csvOf(names: readonly string[], rows: readonly (readonly number[])[]): string {
  const cell = (value: number): string => (Number.isFinite(value) ? String(Number(value.toPrecision(9))) : '');
  return [names.join(','), ...rows.map((row) => row.map(cell).join(',')), ''].join('\n');
}

/** The first visible background from the element upwards. */
function groundOf(element: Element | null): string {
  for (let at = element; at; at = at.parentElement) {
    const { backgroundColor } = getComputedStyle(at);
    if (!/^(transparent|rgba\(0, 0, 0, 0\))$/.test(backgroundColor)) return backgroundColor;
  }
  return '#ffffff';
}
