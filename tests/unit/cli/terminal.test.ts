import { describe, expect, it } from 'vitest';
import { inAscii, oneLine, printable, showsUtf8 } from '../../../web/cli/terminal.ts';

describe('texts for the terminal', () => {
  it('show what a terminal would obey', () => {
    expect(oneLine('a\u001b[31m\u009b2J\u0007b\u202ec\n d')).toBe('a\\u001b[31m\\u009b2J\\u0007b\\u202ec d');
  });

  it('that are JSON stay the same data', () => {
    const data = { name: '\u001b[2J\u007f\u009b\u2028\u202e\u2069 Überkäse 形' };
    const text = printable(JSON.stringify(data));
    expect(JSON.parse(text)).toEqual(data);
    expect(text).not.toMatch(/[\p{Cc}\u2028\u202e\u2069]/u);
    expect(text).toContain('Überkäse 形');
  });

  it('are in ASCII where the terminal has no UTF-8, and stay the same data', () => {
    expect(inAscii('Größe 体 😀')).toBe('Gr\\u00f6\\u00dfe \\u4f53 \\ud83d\\ude00');
    const data = { name: 'Größe 体 😀' };
    expect(JSON.parse(inAscii(JSON.stringify(data)))).toEqual(data);
    const utf8 = [{}, { LANG: 'de_DE.UTF-8' }, { LANG: 'C', LC_ALL: 'en_US.utf8' }, { LANG: 'C', LC_CTYPE: 'C.UTF-8' }];
    expect(utf8.map(showsUtf8)).toEqual([true, true, true, true]);
    const others = [{ LANG: 'C' }, { LANG: 'de_DE.ISO-8859-1' }, { LANG: 'en_US.UTF-8', LC_ALL: 'POSIX' }];
    expect(others.map(showsUtf8)).toEqual([false, false, false]);
  });
});
