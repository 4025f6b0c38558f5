/** Text for the terminal. Names from files must not act as control sequences. */
import { messageOf } from '../engine/api/errors.ts';

/** Control characters except line feeds, and marks of the writing direction, which terminals interpret. */
const COMMANDS = /[\p{Cc}\u2028\u2029\u202a-\u202e\u2066-\u2069]/gu;

/** Escapes control characters as in JSON, so JSON keeps its meaning. */
export function printable(text: string): string {
  return text.replace(COMMANDS, (command) =>
    command === '\n' ? command : `\\u${command.charCodeAt(0).toString(16).padStart(4, '0')}`,
  );
}

export const oneLine = (text: string): string => printable(text.replace(/\s+/g, ' ').trim());

/** Whether a terminal shows UTF-8, according to its locale variables. */
export function showsUtf8({ LC_ALL, LC_CTYPE, LANG }: NodeJS.ProcessEnv, platform: string): boolean {
  return platform === 'win32' || /utf-?8/i.test(LC_ALL || LC_CTYPE || LANG || '');
}

/** Escapes names that a terminal cannot show; files and pipes receive them unchanged. */
export function shownIn({ isTTY }: { isTTY?: boolean }, text: string): string {
  if (!isTTY || showsUtf8(process.env, process.platform)) return printable(text);
  return printable(text).replace(/[^\n -~]/g, (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

/** Prints one line to stderr. */
export const sayError = (text: string): void => {
  process.stderr.write(`${shownIn(process.stderr, oneLine(text))}\n`);
};

/**
 * Resolves when everything is written; rejects with a message on failure. A reader that closed its pipe is not a
 * failure.
 */
export function writeTo(stream: NodeJS.WriteStream, text: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const failed = (error: NodeJS.ErrnoException): void => {
      if (error.code === 'EPIPE') resolve();
      else reject(new Error(`Cannot write the output (${messageOf(error)}).`));
    };
    stream.once('error', failed);
    stream.write(shownIn(stream, text), (error) => {
      if (error) return failed(error);
      stream.off('error', failed);
      resolve();
    });
  });
}
