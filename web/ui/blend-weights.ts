/** The weights of a blend of keys: a bar per key, and a sentence for screen readers. */
import { keyLabel } from '../model/key-names.ts';
import { h, memo, setHidden, setStyle, setText } from './dom.ts';

export interface BlendWeightsProps {
  /** One weight per key, sum 1; null hides the list. */
  weights: readonly number[] | null;
  keys: readonly { name: string }[];
}

/** The sentence is updated when the weights have not changed for this time. */
const REST_MS = 400;

export function createBlendWeights(): { element: HTMLElement; update(props: BlendWeightsProps): void } {
  const rows = h('tbody', {});
  const said = h('p', { class: 'visually-hidden', role: 'status' });
  const table = h(
    'table',
    { class: 'weights', 'data-testid': 'blend-weights' },
    h('caption', { class: 'visually-hidden' }, 'Weights of the keys in the current shape; they sum to 100 %'),
    rows,
  );
  const element = h('div', { hidden: true }, table, said);
  let timer = 0;
  const draw = memo(({ weights, keys }: BlendWeightsProps) => {
    setHidden(element, weights === null);
    window.clearTimeout(timer);
    if (!weights) return setText(said, '');
    while (rows.children.length > weights.length) rows.lastElementChild!.remove();
    while (rows.children.length < weights.length) rows.append(row());
    const [low, high] = [Math.min(0, ...weights), Math.max(1, ...weights)];
    const place = (value: number): number => (100 * (value - low)) / (high - low);
    weights.forEach((weight, key) => {
      const [label, bar, number] = rows.children[key]!.children as unknown as HTMLElement[];
      const [amount, zero] = bar!.firstElementChild!.children as unknown as HTMLElement[];
      setText(label!, keyLabel(key, keys[key]?.name ?? ''));
      setText(number!, percent(weight));
      setStyle(amount!, 'left', `${place(Math.min(weight, 0))}%`);
      setStyle(amount!, 'width', `${place(Math.max(weight, 0)) - place(Math.min(weight, 0))}%`);
      amount!.toggleAttribute('data-negative', weight < 0);
      setStyle(zero!, 'left', `${place(0)}%`);
    });
    timer = window.setTimeout(() => setText(said, sentence(weights)), REST_MS);
  });
  return { element, update: draw };
}

function row(): HTMLElement {
  const bar = h('div', { class: 'weight-bar', 'aria-hidden': 'true' }, h('i', {}), h('b', {}));
  return h('tr', {}, h('th', { scope: 'row' }), h('td', {}, bar), h('td', { class: 'number-cell' }));
}

function percent(weight: number): string {
  const text = (100 * weight).toFixed(1);
  return `${text === '-0.0' ? '0.0' : text.replace('-', '\u2212')}\u00a0%`;
}

function sentence(weights: readonly number[]): string {
  return `Off the curve: ${weights.map((weight, key) => `key ${key + 1} ${percent(weight)}`).join(', ')}`;
}
