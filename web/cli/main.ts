#!/usr/bin/env node
/** Entry point for the terminal: 0 success, 1 bad input, 2 wrong usage; one line on stderr states the problem. */
import { goneFlags } from '../engine/api/gone-options.ts';
import { version } from '../../package.json';
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { parseArguments, UsageError, type Arguments, type Known } from './arguments.ts';
import { complete, inspect } from './commands.ts';
import { measure } from './measure.ts';
import { COMPLETE, HELP, INSPECT, MEASURE, STUDY_GHOST, STUDY_SPACES, STUDY_TABLES } from './settings.ts';
import { studyGhost, studyMethods, studyTables } from './study.ts';
import { sayError, writeTo } from './terminal.ts';

interface Command {
  known: Known;
  run(args: Arguments): Promise<{ text: string; warnings: readonly string[] }>;
}

const COMMANDS = new Map<string, Command>([
  ['inspect', { known: INSPECT, run: async (args) => ({ text: await inspect(args), warnings: [] }) }],
  ['complete', { known: COMPLETE, run: (args) => complete(args, sayError) }],
  ['measure', { known: MEASURE, run: measure }],
  ['study ghost', { known: STUDY_GHOST, run: studyGhost }],
  ['study spaces', { known: STUDY_SPACES, run: studyMethods }],
  ['study tables', { known: STUDY_TABLES, run: studyTables }],
]);

async function run([first, ...rest]: string[]): Promise<string> {
  if (first === '--version') return `${version}\n`;
  if (first === '--help' || first === '-h' || first === 'help' || rest[0] === '--help') return HELP;
  // A study is named by two words.
  const [name, words] = first === 'study' ? [`study ${rest[0] ?? ''}`.trim(), rest.slice(1)] : [first, rest];
  const command = name === undefined ? undefined : COMMANDS.get(name);
  if (!command) {
    const names = [...COMMANDS.keys()].join(', ');
    throw new UsageError(
      name ? `unknown command ${name}: give ${names} (see --help)` : `give a command: ${names} (see --help)`,
    );
  }
  const args = parseArguments(words, command.known);
  if (args.flags.has('help')) return HELP;
  for (const flag of goneFlags(args.values)) sayError(`warning: --${flag} is gone, and has no effect`);
  const { text, warnings } = await command.run(args);
  for (const warning of warnings) sayError(`warning: ${warning}`);
  return text;
}

function exitCodeOf(error: unknown): number {
  const wrongUse = error instanceof UsageError || (error instanceof EngineError && error.code === 'invalid-option');
  return wrongUse ? 2 : 1;
}

try {
  await writeTo(process.stdout, await run(process.argv.slice(2)));
} catch (error) {
  sayError(`shapespline: ${messageOf(error)}`);
  process.exitCode = exitCodeOf(error);
}
