/** Helpers to create and change elements. */

export type Child = Node | string | null | undefined | false;
type Value = string | number | boolean | null | undefined | ((event: never) => void);
export type Props = Record<string, Value>;

/** Displays a part of the state. */
export interface Component<Props> {
  element: HTMLElement;
  update(props: Props): void;
}

/** The update function of several elements inside another component. */
export interface Fields<Props> {
  elements: HTMLElement[];
  update(props: Props): void;
}

/** A component, or an element that does not change. */
export type Part<Props> = Component<Props> | HTMLElement;

export function elementsOf<Props>(parts: readonly Part<Props>[]): HTMLElement[] {
  return parts.map((part) => ('update' in part ? part.element : part));
}

export function updateAll<Props>(parts: readonly Part<Props>[], props: Props): void {
  for (const part of parts) if ('update' in part) part.update(props);
}

/** Parts below each other, hidden unless `isShown`. 'rows': as far apart as the rows around them. */
export function group<P>(
  parts: readonly Part<P>[],
  isShown: (props: P) => boolean = () => true,
  kind: 'group' | 'rows' | 'checks' = 'group',
): Component<P> {
  return shownIf(isShown, withParts(h('div', { class: kind }, ...elementsOf(parts)), parts));
}

/** An element around these parts. */
export function withParts<P>(element: HTMLElement, parts: readonly Part<P>[]): Component<P> {
  return { element, update: (props) => updateAll(parts, props) };
}

/** A part that is hidden unless `isShown`. */
export function shownIf<P>(isShown: (props: P) => boolean, part: Part<P>): Component<P> {
  const element = 'update' in part ? part.element : part;
  return {
    element,
    update(props) {
      setHidden(element, !isShown(props));
      updateAll([part], props);
    },
  };
}

/**
 * An element with attributes, `on...` listeners and children. `true` sets an empty attribute, `false` and null none.
 */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  assign(element, props);
  append(element, children);
  return element;
}

/** Creates an SVG element in the same way. */
export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  props: Props = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  assign(element, props);
  append(element, children);
  return element;
}

function assign(element: Element, props: Props): void {
  for (const [name, value] of Object.entries(props)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as EventListener);
    else setAttribute(element, name, value);
  }
}

function append(element: Element, children: Child[]): void {
  for (const child of children) if (child !== null && child !== undefined && child !== false) element.append(child);
}

export function setAttribute(
  element: Element,
  name: string,
  value: string | number | boolean | null | undefined,
): void {
  const text = value === true ? '' : value === false || value === null || value === undefined ? null : String(value);
  if (element.getAttribute(name) === text) return;
  if (text === null) element.removeAttribute(name);
  else element.setAttribute(name, text);
}

export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function setHidden(element: HTMLElement | SVGElement, hidden: boolean): void {
  setAttribute(element, 'hidden', hidden);
}

/** Sets an element's text, and hides the element if the text is empty. */
export function say(element: HTMLElement, text: string): void {
  setText(element, text);
  setHidden(element, text === '');
}

export function setStyle(element: HTMLElement | SVGElement, name: string, value: string): void {
  if (element.style.getPropertyValue(name) !== value) element.style.setProperty(name, value);
}

/** Sets a field's value; while the user types in it, sets only its defaultValue. */
export function setField(field: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (field instanceof HTMLInputElement && field.type === 'number' && field.defaultValue !== value)
    field.defaultValue = value;
  if (document.activeElement === field && field instanceof HTMLInputElement && field.type !== 'range') return;
  if (field.value !== value) field.value = value;
}

/** Runs `draw` only if a prop has changed since the last call. */
export function memo<P extends object>(draw: (props: P) => void): (props: P) => void {
  let last: P | undefined;
  return (props) => {
    const before = last;
    last = props;
    if (before && (Object.keys(props) as (keyof P)[]).every((key) => Object.is(before[key], props[key]))) return;
    draw(props);
  };
}

let count = 0;

/** An unused element id, for labels and descriptions. */
export function uniqueId(stem: string): string {
  count += 1;
  return `${stem}-${count}`;
}
