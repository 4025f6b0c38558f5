import { describe, expect, it } from 'vitest';
import { oneLine, printable } from '../../../web/cli/terminal.ts';

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
});
