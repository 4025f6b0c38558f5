/** Small controls for the panels: each has a label, a test id, a tooltip with its key, and a reset. */
import type { Child } from './dom.ts';
import { h, setAttribute, setField, setHidden, setText, uniqueId } from './dom.ts';
import type { IconName } from './icons.ts';
import { icon } from './icons.ts';

export interface ButtonOptions {
  label: string;
  testId: string;
  icon?: IconName;
  /** Text beside the icon. */
  text?: string;
  /** Key of the same command, shown in the tooltip. */
  shortcut?: string;
  /** Look of the button; default: plain with text, quiet without. */
  kind?: 'plain' | 'primary' | 'quiet';
  onClick: (event: MouseEvent) => void;
}

export function tooltip(label: string, shortcut?: string): string {
  return shortcut ? `${label} (${shortcut})` : label;
}

export function button(options: ButtonOptions): HTMLButtonElement {
  const { label, testId, text, shortcut, kind = text ? 'plain' : 'quiet', onClick } = options;
  return h(
    'button',
    {
      type: 'button',
      class: `button ${kind}${text ? '' : ' square'}`,
      'data-testid': testId,
      'aria-label': label,
      title: tooltip(label, shortcut),
      onclick: onClick,
    },
    options.icon && icon(options.icon),
    text && h('span', {}, text),
  );
}

/** Hides a reset button with nothing to reset, but keeps its space. */
export function setIdle(reset: HTMLButtonElement, idle: boolean): void {
  reset.disabled = idle;
  setAttribute(reset, 'data-idle', idle);
}

/** A button that restores a default. */
export function resetButton(label: string, testId: string, onClick: () => void): HTMLButtonElement {
  return button({ label, testId, icon: 'reset', onClick });
}

/** Fields in a row after their label. */
export function fieldRow(label: string | Node, ...fields: Child[]): HTMLElement {
  const first = typeof label === 'string' ? h('span', { class: 'label' }, label) : label;
  return h('div', { class: 'field row' }, first, ...fields);
}

export const unit = (text: string): HTMLElement => h('span', { class: 'unit' }, text);

/** A section beside the shape. Its parts can follow later. */
export function panelSection(title: string): HTMLElement {
  const name = title.toLowerCase();
  return h(
    'section',
    { class: 'panel', id: `panel-${name}`, 'aria-labelledby': `${name}-title`, 'data-testid': `panel-${name}` },
    h('header', {}, h('h2', { id: `${name}-title` }, title)),
  );
}

/** Buttons in a row below their label. */
export function buttonGroup(label: string, ...buttons: Node[]): HTMLElement {
  return h(
    'div',
    { class: 'field', role: 'group', 'aria-label': label },
    h('span', { class: 'label' }, label),
    h('div', { class: 'button-row' }, ...buttons),
  );
}

export interface Choice<T extends string> {
  value: T;
  label: string;
  hint?: string;
  disabled?: boolean;
}

interface Segments<T extends string> {
  element: HTMLElement;
  /** `reasons`: for each disabled value, a sentence with the reason. */
  update(value: T, reasons?: Partial<Record<T, string>>): void;
}

/** A row of radio buttons for two to four choices. The reason for a disabled choice is shown below. */
export function segments<T extends string>(
  label: string,
  testId: string,
  choices: readonly Choice<T>[],
  onChange: (value: T) => void,
): Segments<T> {
  const name = uniqueId(testId);
  const reason = h('p', { class: 'reason', id: `${name}-reason`, 'data-testid': `${testId}-reason`, hidden: true });
  const inputs = choices.map(({ value }) =>
    h('input', {
      type: 'radio',
      name,
      value,
      'data-testid': `${testId}-${value}`,
      'aria-describedby': reason.id,
      onchange: () => onChange(value),
    }),
  );
  const row = h(
    'div',
    { class: 'segments' },
    ...choices.map(({ label: text, hint }, index) => {
      const input = inputs[index];
      return h('label', { title: hint }, input, h('span', {}, text));
    }),
  );
  const element = h('fieldset', { class: 'field', 'data-testid': testId }, h('legend', {}, label), row, reason);
  return {
    element,
    update(value, reasons = {}) {
      for (const input of inputs) {
        input.checked = input.value === value;
        input.disabled = reasons[input.value as T] !== undefined;
      }
      const texts = [...new Set(Object.values(reasons) as string[])];
      setText(reason, texts.join(' '));
      setHidden(reason, texts.length === 0);
    },
  };
}

interface Select<T extends string> {
  element: HTMLElement;
  field: HTMLSelectElement;
  update(value: T, choices?: readonly Choice<T>[]): void;
}

export function select<T extends string>(
  label: string,
  testId: string,
  choices: readonly Choice<T>[],
  onChange: (value: T) => void,
  shortcut?: string,
): Select<T> {
  const id = uniqueId(testId);
  const field = h('select', {
    id,
    'data-testid': testId,
    title: tooltip(label, shortcut),
    onchange: () => onChange(field.value as T),
  });
  let shown: readonly Choice<T>[] = [];
  const fill = (next: readonly Choice<T>[]): void => {
    if (
      next.length === shown.length &&
      next.every((c, i) => c.value === shown[i]?.value && c.label === shown[i]?.label)
    )
      return;
    shown = next;
    field.replaceChildren(
      ...next.map(({ value, label: text, hint, disabled }) => h('option', { value, title: hint, disabled }, text)),
    );
  };
  fill(choices);
  return {
    field,
    element: h(
      'div',
      { class: 'field' },
      h('label', { for: id }, label),
      h('div', { class: 'select' }, field, icon('down')),
    ),
    update(value, next) {
      if (next) fill(next);
      setField(field, value);
    },
  };
}

interface SliderOptions {
  label: string;
  testId: string;
  /** Ends of the slider. */
  first: number;
  last: number;
  /** Bounds of the number field, if it reaches further. */
  min?: number | undefined;
  max?: number | undefined;
  step: number | 'any';
  /** Value restored by the reset button. */
  fallback: number;
  hint?: string | undefined;
  onInput: (value: number) => void;
}

interface Slider {
  element: HTMLElement;
  /** `reach`: the slider's end if it differs from `last`. */
  update(value: number, shown?: { disabled?: boolean; reach?: number }): void;
}

/** A slider with a number field and a reset button. */
export function slider(options: SliderOptions): Slider {
  const { label, testId, first, last, min = first, max = last, step, fallback, hint, onInput } = options;
  const format = (value: number): string => String(Number(value.toFixed(3)));
  const id = uniqueId(testId);
  const range = h('input', {
    type: 'range',
    id,
    min: first,
    max: last,
    step,
    'data-testid': testId,
    title: hint,
    oninput: () => onInput(Number(range.value)),
  });
  const typed = { min, max, step, onInput };
  const number = numberField({ label: `${label}, as a number`, testId: `${testId}-number`, ...typed });
  const reset = resetNumber(options, () => onInput(fallback));
  const element = h(
    'div',
    { class: 'field slider' },
    h('label', { for: id, title: hint }, label),
    h('div', { class: 'slider-row' }, range, number, reset),
  );
  return {
    element,
    update(value, { disabled = false, reach = last } = {}) {
      setAttribute(range, 'max', reach);
      if (Number(range.value) !== value) range.value = String(value);
      setAttribute(range, 'aria-valuetext', format(value));
      setField(number, format(value));
      for (const control of [range, number]) control.disabled = disabled;
      setIdle(reset, disabled || value === fallback);
    },
  };
}

function resetNumber(
  { label, testId, fallback }: { label: string; testId: string; fallback: number | null },
  onClick: () => void,
): HTMLButtonElement {
  const to = fallback === null ? '' : ` to ${fallback.toLocaleString('en')}`;
  return resetButton(`Reset ${label.toLowerCase()}${to}`, `${testId}-reset`, onClick);
}

interface NumberRowOptions extends Omit<NumberFieldOptions, 'onInput'> {
  /** Tooltip of the label. */
  hint?: string | undefined;
  /** Name for screen readers; default: label and unit. */
  name?: string | undefined;
  unit?: string | undefined;
  /** Element after the number. */
  beside?: HTMLElement | undefined;
  /** Value of the reset button; undefined: there is none. */
  fallback?: number | null | undefined;
  onInput: (value: number | null) => void;
}

interface NumberRow {
  element: HTMLElement;
  update(value: number | null, shown?: { text?: string; placeholder?: string; disabled?: boolean }): void;
}

/** A number in a row with its label, unit and reset button. */
export function numberRow(options: NumberRowOptions): NumberRow {
  const { label, hint, unit: of, beside, fallback, onInput } = options;
  const { name = of ? `${label}, ${of}` : label } = options;
  const field = numberField({ ...options, label: name });
  const reset = fallback === undefined ? null : resetNumber({ ...options, fallback }, () => onInput(fallback));
  return {
    element: fieldRow(h('span', { class: 'label', title: hint }, label), field, of && unit(of), beside, reset),
    update(value, { text = String(value), placeholder = '', disabled = false } = {}) {
      setField(field, text);
      field.placeholder = placeholder;
      field.disabled = disabled;
      if (reset) setIdle(reset, disabled || value === fallback);
    },
  };
}

interface NumberFieldOptions {
  label: string;
  testId: string;
  min?: number | undefined;
  max?: number | undefined;
  step?: number | 'any';
  /** Meaning of an empty field. */
  empty?: number | undefined;
  /** Why a number is refused, after 'must be'; null: it is not. */
  validationError?: ((value: number) => string | null) | undefined;
  onInput: (value: number) => void;
}

/** Event of a field that refuses typed text. It bubbles; its detail is a sentence with the reason. */
export const REFUSED = 'refused';

/**
 * A field for one number, which is rounded if the step is a whole number. On blur it shows the value in effect, as set
 * by setField. Invalid text is replaced, and a number beyond a limit becomes the limit.
 */
export function numberField(options: NumberFieldOptions): HTMLInputElement {
  const { label, testId, min = -Infinity, max = Infinity, step = 'any', empty, validationError, onInput } = options;
  const name = label.split(/[;,]/)[0]!;
  const refuse = (why: string): void => {
    field.dispatchEvent(new CustomEvent(REFUSED, { bubbles: true, detail: `${name} must be ${why}.` }));
  };
  const take = (): void => {
    const value = field.valueAsNumber;
    if (field.value === '' && !field.validity.badInput) return empty === undefined ? undefined : onInput(empty);
    if (!Number.isFinite(value)) return refuse('a number');
    if (value < min) refuse(`at least ${min}`);
    if (value > max) refuse(`at most ${max}`);
    const wrong = validationError?.(value);
    if (wrong) return refuse(wrong);
    const typed = Math.min(Math.max(value, min), max);
    onInput(step !== 'any' && Number.isInteger(step) ? Math.round(typed) : typed);
  };
  const commit = (): void => {
    take();
    // The page has drawn the result by then.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (document.activeElement !== field) field.value = field.defaultValue;
      }),
    );
  };
  const field = h('input', {
    type: 'number',
    class: 'number',
    min: options.min,
    max: options.max,
    step,
    inputmode: 'decimal',
    'data-testid': testId,
    'aria-label': label,
    title: label,
    onchange: commit,
    onfocus: () => field.select(),
    onkeydown: (event: KeyboardEvent) => {
      if (event.key === 'Enter') field.blur();
    },
  });
  return field;
}

export interface Toggle {
  element: HTMLElement;
  update(on: boolean, disabled?: boolean): void;
}

export function checkbox(label: string, testId: string, onChange: (on: boolean) => void, shortcut?: string): Toggle {
  const input = h('input', { type: 'checkbox', 'data-testid': testId, onchange: () => onChange(input.checked) });
  return {
    element: h('label', { class: 'check', title: tooltip(label, shortcut) }, input, h('span', {}, label)),
    update(on, disabled = false) {
      input.checked = on;
      input.disabled = disabled;
    },
  };
}

interface DialogOptions {
  title: string;
  label: string;
  testId: string;
  /** Test id of the button that closes it. */
  closeId: string;
  /** An additional CSS class. */
  kind?: string;
}

/** A dialog with a title over the page. Its button, Escape, or a press outside closes it. */
export function dialog({ title, label, testId, closeId, kind }: DialogOptions, ...content: Child[]): HTMLDialogElement {
  const close = button({ label: 'Close', testId: closeId, icon: 'close', onClick: () => element.close() });
  const element = h(
    'dialog',
    { class: kind ? `dialog ${kind}` : 'dialog', 'data-testid': testId, 'aria-label': label },
    h('header', {}, h('h2', {}, title), close),
    ...content,
  );
  element.addEventListener('click', (event) => {
    if (event.target === element) element.close();
  });
  return element;
}
