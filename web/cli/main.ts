#!/usr/bin/env node
/** Entry point for the terminal: 0 success, 1 bad input, 2 wrong usage; one line on stderr states the problem. */
import { version } from '../../package.json';
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { parseArguments, UsageError } from './arguments.ts';
import { complete, inspect } from './commands.ts';
import { measure } from './measure.ts';
import { COMPLETE, HELP, INSPECT, MEASURE } from './settings.ts';
import { sayError, writeTo } from './terminal.ts';

const COMMANDS = new Map([
  ['inspect', INSPECT],
  ['complete', COMPLETE],
  ['measure', MEASURE],
]);

async function run([command, ...words]: string[]): Promise<string> {
  if (command === '--version') return `${version}\n`;
  if (command === '--help' || command === '-h' || command === 'help') return HELP;
  const known = command === undefined ? undefined : COMMANDS.get(command);
  if (!known) {
    const names = [...COMMANDS.keys()].join(', ');
    throw new UsageError(command ? `unknown command ${command} (see --help)` : `give a command: ${names} (see --help)`);
  }
  const args = parseArguments(words, known);
  if (args.flags.has('help')) return HELP;
  if (command === 'inspect') return inspect(args);
  const { text, warnings } = command === 'measure' ? await measure(args) : await complete(args, sayError);
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
