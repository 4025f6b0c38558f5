/** Texts on their way to the terminal, where names out of files must not be more than text. */
import { messageOf } from '../engine/api/errors.ts';

/** Control characters but the line feed, and what turns the direction of writing: terminals obey them. */
const COMMANDS = /[\p{Cc}\u2028\u2029\u202a-\u202e\u2066-\u2069]/gu;

/** Commands to a terminal are shown as JSON would write them, so that JSON stays the same data. */
export function printable(text: string): string {
  return text.replace(COMMANDS, (command) =>
    command === '\n' ? command : `\\u${command.charCodeAt(0).toString(16).padStart(4, '0')}`,
  );
}

/** Whether the terminal shows UTF-8: it does where its locale does not name another encoding. */
export function showsUtf8(env: Readonly<Record<string, string | undefined>>): boolean {
  const locale = env['LC_ALL'] || env['LC_CTYPE'] || env['LANG'] || '';
  return locale === '' || /utf-?8/i.test(locale);
}

/** For terminals of other encodings: what is not ASCII, as JSON would write it, so that JSON stays the same data. */
export function inAscii(text: string): string {
  return text.replace(/[^\0-\x7f]/g, (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

/** As this stream can show it; files and pipes take UTF-8. */
export function shownOn(stream: Pick<NodeJS.WriteStream, 'isTTY'>, text: string): string {
  const plain = printable(text);
  return stream.isTTY && !showsUtf8(process.env) ? inAscii(plain) : plain;
}

export const oneLine = (text: string): string => printable(text.replace(/\s+/g, ' ').trim());

/**
 * Resolves when all of it is written; rejects with a sentence where it cannot be. A reader that has gone wants no more.
 */
export function writeTo(stream: NodeJS.WriteStream, text: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const failed = (error: NodeJS.ErrnoException): void => {
      if (error.code === 'EPIPE') resolve();
      else reject(new Error(`The output cannot be written to its place (${messageOf(error)}).`));
    };
    stream.once('error', failed);
    stream.write(shownOn(stream, text), (error) => {
      if (error) return failed(error);
      stream.off('error', failed);
      resolve();
    });
  });
}
