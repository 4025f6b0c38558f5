/**
 * Built-in functions that old libraries replace on a page. Scripts of the package that run on pages use these instead
 * (`wasm/toolchain/npm-package`). Prototype and MooTools replace `Array.from` by a function without iterators, and
 * Prototype's `Array.prototype.toJSON` makes `JSON.stringify` write arrays as text.
 */

export function arrayFrom<T, U = T>(
  given: Iterable<T> | ArrayLike<T>,
  convert: (item: T, index: number) => U = (item) => item as unknown as U,
): U[] {
  const items = Symbol.iterator in Object(given) ? [...(given as Iterable<T>)] : (given as ArrayLike<T>);
  const list: U[] = [];
  for (let i = 0; i < items.length; i += 1) list.push(convert(items[i]!, i));
  return list;
}

const { stringify: write } = JSON;

export function stringify(...given: Parameters<typeof JSON.stringify>): string {
  const replaced = Object.getOwnPropertyDescriptor(Array.prototype, 'toJSON');
  if (!replaced?.configurable) return write(...given);
  delete (Array.prototype as { toJSON?: unknown }).toJSON;
  try {
    return write(...given);
  } finally {
    Object.defineProperty(Array.prototype, 'toJSON', replaced);
  }
}
