/** Full turns since the previous key, for the whole shape or one component. */
import { MAX_TURNS } from '../engine/api/option-table.ts';
import { OPTION_WORDS } from '../model/option-words.ts';
import type { KeyTurns, Shaping } from '../model/shaping.ts';
import { turnsOf } from '../model/shaping.ts';
import type { Choice } from './controls.ts';
import { numberRow, select } from './controls.ts';
import { setHidden } from './dom.ts';

/** Most components in the list. More entries are not distinguishable. */
const MAX_COMPONENTS = 400;

export interface KeyTurnsProps {
  shaping: Shaping;
  /** Whether turns can be added: not at the first key, and not with every method. */
  canTurn: boolean;
  /** Number of components of the shape. */
  components: number;
}

/** onComponent receives the selected component; null for the whole shape. */
export function createKeyTurns(
  onTurns: (added: KeyTurns) => void,
  onComponent: (component: number | null) => void,
): {
  elements: HTMLElement[];
  update(props: KeyTurnsProps): void;
  /** Selects the whole shape again. */
  reset(): void;
} {
  let props: KeyTurnsProps | null = null;
  let component: number | null = null;
  const row = numberRow({
    ...OPTION_WORDS.turns,
    testId: 'key-turns',
    min: -MAX_TURNS,
    max: MAX_TURNS,
    step: 1,
    onInput: (turns) => onTurns({ ...(component === null ? {} : { component }), turns: turns ?? 0 }),
  });
  const turning = select<string>('Of', 'key-turns-component', [], (value) =>
    choose(value === '' ? null : Number(value)),
  );
  turning.element.classList.add('row');

  const choose = (chosen: number | null): void => {
    if (component === chosen) return;
    component = chosen;
    onComponent(component);
    draw();
  };
  const draw = (): void => {
    if (!props) return;
    const { shaping, canTurn, components } = props;
    const count = canTurn && components > 1 ? Math.min(components, MAX_COMPONENTS) : 0;
    if (component !== null && component >= count) return choose(null);
    row.update(turnsOf(shaping, component ?? undefined));
    setHidden(row.element, !canTurn);
    setHidden(turning.element, count === 0);
    turning.update(String(component ?? ''), count === 0 ? [] : componentChoices(count, shaping));
  };
  return {
    elements: [row.element, turning.element],
    update(next) {
      props = next;
      draw();
    },
    reset: () => choose(null),
  };
}

/** Marks components that already have turns. */
function componentChoices(count: number, shaping: Shaping): Choice<string>[] {
  const label = (component: number): string => {
    const turns = turnsOf(shaping, component);
    return `Component ${component + 1}${turns === 0 ? '' : `: ${turns > 0 ? '+' : ''}${turns}`}`;
  };
  const each = Array.from({ length: count }, (_, component) => ({ value: String(component), label: label(component) }));
  return [{ value: '', label: 'Whole shape' }, ...each];
}
