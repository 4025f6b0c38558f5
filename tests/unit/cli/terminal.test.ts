import { describe, expect, it } from 'vitest';
import { oneLine, printable, showsUtf8, shownIn } from '../../../web/cli/terminal.ts';

describe('texts for the terminal', () => {
  it('are escaped if the locale is not UTF-8', () => {
    expect(showsUtf8({ LANG: 'de_DE.UTF-8' }, 'linux')).toBe(true);
    expect(showsUtf8({ LANG: 'C.utf8' }, 'linux')).toBe(true);
    expect(showsUtf8({ LC_ALL: 'C', LANG: 'de_DE.UTF-8' }, 'linux')).toBe(false);
    expect(showsUtf8({ LC_ALL: '', LC_CTYPE: 'en_US.UTF-8', LANG: 'C' }, 'linux')).toBe(true);
    expect([showsUtf8({}, 'linux'), showsUtf8({}, 'win32')]).toEqual([false, true]);
    const before = process.env.LC_ALL;
    process.env.LC_ALL = 'C';
    try {
      expect(shownIn({ isTTY: true }, 'Körper 形\n')).toBe('K\\u00f6rper \\u5f62\n');
      expect(shownIn({}, 'Körper 形\n')).toBe('Körper 形\n');
    } finally {
      if (before === undefined) delete process.env.LC_ALL;
      else process.env.LC_ALL = before;
    }
  });

  it('show control characters as text', () => {
    expect(oneLine('a\u001b[31m\u009b2J\u0007b\u202ec\n d')).toBe('a\\u001b[31m\\u009b2J\\u0007b\\u202ec d');
  });

  it('that are JSON keep the same data', () => {
    const data = { name: '\u001b[2J\u007f\u009b\u2028\u202e\u2069 Überkäse 形' };
    const text = printable(JSON.stringify(data));
    expect(JSON.parse(text)).toEqual(data);
    expect(text).not.toMatch(/[\p{Cc}\u2028\u202e\u2069]/u);
    expect(text).toContain('Überkäse 形');
  });
});
