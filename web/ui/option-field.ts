/**
 * The control of an option: its bounds and default are from the option table, its words from OPTION_WORDS, and the
 * reasons why it is disabled from the rules.
 */
import { ENCODING, MOTION, PER_KEY } from '../engine/api/option-table.ts';
import type { NumberOption, Option } from '../engine/api/option-table.ts';
import { reasonFor, reasonsForChoices } from '../model/option-reasons.ts';
import type { Reasons } from '../model/option-reasons.ts';
import { OPTION_WORDS } from '../model/option-words.ts';
import type { PageOptionName, WordedOption } from '../model/option-words.ts';
import type { Doc, Encoding, Motion } from '../model/state.ts';
import type { Choice } from './controls.ts';
import { checkbox, numberRow, resetButton, segments, select, setIdle, slider } from './controls.ts';
import type { Component, Part } from './dom.ts';
import { elementsOf, h, memo, setText, updateAll } from './dom.ts';

const TABLE: Readonly<Record<WordedOption, Option>> = { ...MOTION, ...ENCODING, ...PER_KEY };

/** More choices than this are in a list. */
const MAX_SEGMENTS = 4;

const SLIDER_STEP = 0.05;

type Value = string | number | null;

/** What a control shows beside its value. */
interface Shown {
  disabled?: boolean;
  /** Reasons why choices are disabled. */
  reasons?: Reasons;
  /** The choices, if they are not fixed. */
  choices?: readonly Choice<string>[];
  /** Text of a number, instead of the value; placeholder if it is empty. */
  text?: string;
  placeholder?: string;
  /** The slider's last number, instead of the usual one. */
  reach?: number;
  /** Text after the chosen one's hint. */
  note?: string;
}

interface Control {
  element: HTMLElement;
  update(value: Value, shown: Shown): void;
}

interface ControlOptions {
  /** Begins the test id. */
  prefix?: string;
  /** Element beside a number. */
  beside?: HTMLElement;
  /** Why a number within the bounds is refused, after 'must be'. */
  validationError?: (value: number) => string | null;
}

/** The option's bounds, and the value of the reset button; undefined: there is none. */
export function numberBounds(name: WordedOption) {
  const { min, max, whole, default: usual = null } = TABLE[name] as NumberOption;
  const { slider: ends, start = usual, canBeEmpty, step } = OPTION_WORDS[name];
  const usualStep = whole ? 1 : ends ? SLIDER_STEP : ('any' as const);
  return { min, max, step: step ?? usualStep, fallback: canBeEmpty ? undefined : start };
}

export function optionControl(
  name: WordedOption,
  onInput: (value: never) => void,
  options: ControlOptions = {},
): Control {
  const { choices, explains, note } = OPTION_WORDS[name];
  const testId = (options.prefix ?? '') + name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
  const control = controlOf(name, testId, onInput as (value: Value) => void, options);
  if (!explains && !note) return control;
  const below = h('p', { class: 'hint', 'data-testid': `${testId}-hint` }, note);
  return {
    element: h('div', { class: 'rows' }, control.element, below),
    update(value, shown) {
      control.update(value, shown);
      if (explains) setText(below, `${choices?.[String(value)]?.hint ?? ''}${shown.note ?? ''}`);
    },
  };
}

function controlOf(
  name: WordedOption,
  testId: string,
  onInput: (value: Value) => void,
  { beside, validationError }: ControlOptions,
): Control {
  const { kind, default: usual } = TABLE[name];
  const { label, choices, ticked, shortcut, slider: ends, canBeEmpty, ...words } = OPTION_WORDS[name];
  if (ticked !== undefined) {
    const box = checkbox(label, testId, (on) => onInput(on ? ticked : (usual as string)), shortcut);
    return { element: box.element, update: (value, { disabled }) => box.update(value === ticked, disabled) };
  }
  if (choices || kind !== 'number') {
    const fixed = Object.entries(choices ?? {}).map(([value, one]) => ({ value, ...one }));
    const take = (value: string): void => onInput(kind === 'number' ? Number(value) : value);
    if (fixed.length === 0 || fixed.length > MAX_SEGMENTS) {
      const list = select(label, testId, fixed, take, shortcut);
      return { element: list.element, update: (value, shown) => list.update(String(value ?? ''), shown.choices) };
    }
    const row = segments(label, testId, fixed, take);
    return { element: row.element, update: (value, { reasons }) => row.update(String(value), reasons) };
  }
  const shared = { ...words, ...numberBounds(name), label, testId, onInput };
  if (ends) {
    const control = slider({ ...shared, first: ends[0], last: ends[1], fallback: shared.fallback ?? 0 });
    return { element: control.element, update: (value, shown) => control.update(Number(value), shown) };
  }
  const empty = canBeEmpty ? (usual as number) : undefined;
  const row = numberRow({ ...shared, empty, beside, validationError });
  return { element: row.element, update: (value, shown) => row.update(value as number | null, shown) };
}

/** What a panel of options shows; `defaults`: the values that its reset button restores. */
export interface OptionPanelProps<Options> extends OptionProps {
  defaults: Options;
}

/**
 * Fills a panel beside the shape with rows, and adds a button that resets `options`, a part of the document.
 */
export function fillPanel<N extends 'motion' | 'encoding', P extends OptionPanelProps<Doc[N]>>(
  element: HTMLElement,
  options: N,
  onReset: () => void,
  parts: readonly Part<P>[],
): Component<P> {
  const name = element.id.replace('panel-', '');
  const reset = resetButton(`Reset the ${name} options to their state when opened`, `${name}-reset`, onReset);
  element.querySelector('header')!.append(reset);
  element.append(...elementsOf(parts));
  const update = memo((props: P) => {
    updateAll(parts, props);
    const names = Object.keys(props.defaults) as (keyof Doc[N])[];
    setIdle(
      reset,
      names.every((one) => props[options][one] === props.defaults[one]),
    );
  });
  return { element, update };
}

export interface OptionProps extends Readonly<Doc> {
  disabled: boolean;
}

/** A row of a panel: the control of an option of the document. `more`: what it shows beside the value. */
export function optionField<P extends OptionProps>(
  name: PageOptionName,
  onChange: (change: Partial<Motion & Encoding>) => void,
  more: (props: P) => Shown = () => ({}),
  options: ControlOptions = {},
): Component<P> {
  const page = TABLE[name].page as keyof (Motion & Encoding);
  const { element, update } = optionControl(name, (value) => onChange({ [page]: value }), options);
  return {
    element,
    update(props) {
      const disabled = props.disabled || reasonFor(name, props) !== '';
      const value = { ...props.motion, ...props.encoding }[page];
      update(value as Value, { disabled, reasons: reasonsForChoices(name, props), ...more(props) });
    },
  };
}
