/** A plot as a file: an SVG that needs no style sheet, the same as a PNG, and numbers as CSV. */

/** What the style sheet says of a plot's parts. */
const STYLED = [
  ...['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'stroke-linejoin'],
  ...['opacity', 'paint-order', 'font-family', 'font-size', 'font-weight', 'text-anchor'],
] as const;

/** The picture as it is on the page, on the page's ground, each part with its own colours. */
export function svgOf(element: SVGSVGElement): string {
  const copy = element.cloneNode(true) as SVGSVGElement;
  const { width, height } = element.viewBox.baseVal;
  const from = [element, ...element.querySelectorAll('*')];
  const to = [copy, ...copy.querySelectorAll('*')];
  const hidden: Element[] = [];
  from.forEach((part, index) => {
    const style = getComputedStyle(part);
    const target = to[index]!;
    if (style.display === 'none') hidden.push(target);
    for (const name of STYLED) target.setAttribute(name, style.getPropertyValue(name));
    for (const paint of ['fill', 'stroke']) {
      const { colour, opacity } = plainColour(style.getPropertyValue(paint));
      target.setAttribute(paint, colour);
      const own = Number(style.getPropertyValue(`${paint}-opacity`));
      target.setAttribute(`${paint}-opacity`, String(Number((own * opacity).toPrecision(3))));
    }
    for (const { name } of [...target.attributes])
      if (/^(class|tabindex|role|data-.*|aria-.*)$/.test(name)) target.removeAttribute(name);
  });
  for (const part of hidden) part.remove();
  const ground = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  for (const [name, value] of Object.entries({ width, height, fill: groundOf(element) }))
    ground.setAttribute(name, String(value));
  copy.prepend(ground);
  for (const [name, value] of Object.entries({ width, height })) copy.setAttribute(name, String(value));
  return new XMLSerializer().serializeToString(copy);
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

/** Errors: where the browser cannot draw the picture. */
export async function pngOf(element: SVGSVGElement, scale = 3): Promise<Blob> {
  const { width, height } = element.viewBox.baseVal;
  const url = URL.createObjectURL(new Blob([svgOf(element)], { type: 'image/svg+xml' }));
  try {
    const image = new Image(width * scale, height * scale);
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [width * scale, height * scale];
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
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
