/**
 * Parses the command line into values by name. Every option except flags takes a value, which may begin with a minus.
 */

/** Wrong usage: one line, exit code 2. */
export class UsageError extends Error {}

export interface Arguments {
  files: string[];
  values: Map<string, string>;
  flags: Set<string>;
}

/** Separates the values of a repeated option; no argument contains it. */
export const BETWEEN_VALUES = '\0';

export interface Known {
  options: ReadonlySet<string>;
  /** Options that may be repeated. */
  repeated: ReadonlySet<string>;
  flags: ReadonlySet<string>;
}

export function parseArguments(words: string[], known: Known): Arguments {
  const result: Arguments = { files: [], values: new Map(), flags: new Set() };
  const rest = [...words];
  for (let word = rest.shift(); word !== undefined; word = rest.shift()) {
    if (word === '--') {
      result.files.push(...rest.splice(0));
    } else if (word.startsWith('-') && word.length > 1) {
      takeOption(word, rest, known, result);
    } else {
      result.files.push(word);
    }
  }
  return result;
}

function takeOption(word: string, rest: string[], known: Known, result: Arguments): void {
  const [, dashes, name = '', given] = /^(--?)([^=]*)(?:=(.*))?$/s.exec(word) ?? [];
  if (dashes === '--' && known.flags.has(name)) {
    if (given !== undefined) throw new UsageError(`--${name} takes no value`);
    result.flags.add(name);
    return;
  }
  if (dashes !== '--' || !known.options.has(name))
    throw new UsageError(`unknown option ${word.split('=')[0]} (see --help)`);
  const value = given ?? takeValue(rest, known);
  if (value === undefined || value === '') throw new UsageError(`--${name} needs a value`);
  const before = result.values.get(name);
  if (before !== undefined && !known.repeated.has(name)) throw new UsageError(`--${name} is given twice`);
  result.values.set(name, before === undefined ? value : before + BETWEEN_VALUES + value);
}

// The next word, unless it is an option: -0.3,1.3 is a value, --report is not.
function takeValue(rest: string[], known: Known): string | undefined {
  const name = /^--([^=]*)/.exec(rest[0] ?? '')?.[1];
  return name !== undefined && (known.options.has(name) || known.flags.has(name)) ? undefined : rest.shift();
}
