/** Converts attributes to property values and back, by the table's rows. */
import type { Row } from './attributes.ts';

export interface Read {
  value: unknown;
  /** Reason why the text is invalid and the default applies. */
  problem: string | null;
}

const good = (value: unknown): Read => ({ value, problem: null });
const bad = ({ default: usual }: Row, problem: string): Read => ({ value: usual, problem });

/** `text`: null if the attribute is absent. */
export function readAttribute(row: Row, text: string | null): Read {
  if (text === null) return good(row.default);
  const word = text.trim();
  switch (row.kind) {
    case 'text':
      return word === '' || row.reads === undefined || row.reads(word) !== null
        ? good(word)
        : bad(row, `must look like \`${row.sample}\``);
    case 'flag':
      return word.toLowerCase() === 'false'
        ? { value: false, problem: 'is "false", which counts as false; omit the attribute instead' }
        : good(true);
    case 'choice': {
      if (word === '') return good(row.empty ?? row.default);
      if (row.choices.includes(word)) return good(word);
      if (word === 'false' && row.empty !== undefined)
        return bad(row, 'is "false", which counts as false; omit the attribute instead');
      return bad(row, `must be one of ${row.choices.join(', ')}`);
    }
    case 'number':
      return numberOf(row, word);
    case 'numbers':
      return numbersOf(row, word);
    case 'words': {
      const words = word.split(/[\s,]+/).filter(Boolean);
      return words.every((one) => row.choices.includes(one))
        ? good(words)
        : bad(row, `must be a list of ${row.choices.join(', ')}`);
    }
  }
}

function numberOf(row: Extract<Row, { kind: 'number' }>, word: string): Read {
  const number = Number(word === '' ? NaN : word);
  const { min = -Infinity, above = -Infinity, max, whole = false } = row;
  if (!Number.isFinite(number)) return bad(row, 'must be a number');
  if (whole && !Number.isInteger(number)) return bad(row, 'must be a whole number');
  if (number < min || number <= above || number > max)
    return bad(row, `must be ${above > -Infinity ? `above ${above}` : `at least ${min}`} and at most ${max}`);
  return good(number);
}

function numbersOf(row: Extract<Row, { kind: 'numbers' }>, word: string): Read {
  if (word === '') return good(row.default);
  const numbers = word.split(/[\s,:]+/).map(Number);
  if (numbers.some((number) => !Number.isFinite(number))) return bad(row, 'must be numbers, separated by spaces');
  if (row.count !== undefined && numbers.length !== row.count) return bad(row, `must be ${row.count} numbers`);
  if (row.count === 2 && numbers[0]! >= numbers[1]!) return bad(row, 'must be two numbers, the smaller number first');
  return good(numbers);
}

/** The attribute for a property value; null for none. */
export function writeAttribute(row: Row, value: unknown): string | null {
  if (value === null || value === undefined) return null;
  switch (row.kind) {
    case 'flag':
      return value ? '' : null;
    case 'numbers':
    case 'words': {
      const list = Array.isArray(value) ? value : [value];
      return list.length === 0 ? null : list.join(' ');
    }
    case 'choice':
      if (value === '' || value === false) return null;
      return value === true ? (row.empty ?? null) : String(value);
    case 'text':
      return value === '' ? null : String(value);
    case 'number':
      return String(value);
  }
}
