/** Legend of a heat map: its colours with range and unit, and the numbers at the current time. */
import { h, memo, setAttribute, setHidden, setStyle, setText } from './dom.ts';

export interface ColourBarProps {
  title: string;
  unit: string;
  /** The unit as written after a number. */
  symbol: string;
  /** Upper end of the range, which starts at 0. */
  top: number;
  /** Larger values exist and have the top colour. */
  beyond?: boolean;
  /** Numbers at the current time. */
  now: string;
  /** Left edge and middle of its view, in CSS pixels. */
  x: number;
  y: number;
  /** The bar is shown along the upper edge instead. */
  along: boolean;
}

/** `gradient`: the colours as CSS, from bottom to top. */
export function createColourBar(gradient: string): {
  element: HTMLElement;
  update(props: ColourBarProps | null): void;
} {
  const title = h('strong', {});
  const unit = h('div', { class: 'muted' });
  const ramp = h('div', { class: 'ramp' });
  ramp.style.background = gradient;
  const ticks = h('div', { class: 'ramp-ticks' }, h('span', {}), h('span', {}), h('span', {}));
  const now = h('span', { class: 'muted', 'data-testid': 'colour-bar-now' });
  const element = h(
    'div',
    { class: 'colour-bar', 'data-testid': 'colour-bar', hidden: true },
    h('div', {}, title, unit),
    h('div', { class: 'ramp-row' }, ramp, ticks),
    now,
  );
  const draw = memo((props: ColourBarProps) => {
    setText(title, props.title);
    setText(unit, props.unit);
    const end = props.beyond ? '≥ ' : '';
    [1, 0.5, 0].forEach((share, index) => {
      const amount = `${Number((share * props.top).toPrecision(3))} ${props.symbol}`;
      setText(ticks.children[index]!, index === 0 ? end + amount : amount);
    });
    setText(now, props.now);
    setAttribute(element, 'data-along', props.along);
    setStyle(element, 'left', `${props.x}px`);
    setStyle(element, 'top', `${props.y}px`);
  });
  return {
    element,
    update(props) {
      setHidden(element, props === null);
      if (props) draw(props);
    },
  };
}
