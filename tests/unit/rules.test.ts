/** The rules of options: the engine, the command line and comparisons agree on every option and method. */
import { describe, expect, it } from 'vitest';
import { motionFor } from '../../web/engine/api/method-options.ts';
import { METHODS } from '../../web/engine/api/methods.ts';
import { checkRules } from '../../web/engine/api/options.ts';
import { conflicts, RULES, type RuledOption } from '../../web/engine/api/rules.ts';
import { MOTION_DEFAULTS, type MotionOptions } from '../../web/engine/api/types.ts';
import { parseArguments } from '../../web/cli/arguments.ts';
import { COMPLETE, sequenceOptions } from '../../web/cli/settings.ts';

/** A value of each option, as in the engine and on the command line. */
const USED: readonly [Partial<MotionOptions>, string][] = [
  [{ boundary: 'hermite' }, '--boundary=hermite'],
  [{ boundary: 'periodic' }, '--boundary=periodic'],
  [{ tension: [0, 1, 0] }, '--tension=0,1,0'],
  [{ bias: [0, 0.5, 0] }, '--bias=0,0.5,0'],
  [{ earlier: [0.2, 0, 0] }, '--earlier=0.2,0,0'],
  [{ swing: [0, -1, 0] }, '--swing=0,-1,0'],
  [{ hold: 'on' }, '--hold=on'],
  [{ pins: [{ vertex: 3, radius: 0.1 }] }, '--pin=3:0.1'],
  [{ turns: [{ key: 1, turns: 1 }] }, '--turns=2:1'],
  [{ keepLengths: 1 }, '--keep-lengths=1'],
];

function refuses(check: () => unknown): boolean {
  try {
    check();
    return false;
  } catch {
    return true;
  }
}

describe.each(METHODS)('the method %s', (method) => {
  const pairs = USED.flatMap((one, i) => USED.slice(i).map((other) => [one, other] as const));

  it('refuses the same given options in the engine and on the command line', () => {
    for (const [[one, flag], [other, otherFlag]] of pairs) {
      const given = { method, ...one, ...other };
      const words = [...new Set([flag, otherFlag])].filter(
        (text, i, all) => i === all.findLastIndex((same) => same.split('=')[0] === text.split('=')[0]),
      );
      const byEngine = refuses(() => checkRules({ ...MOTION_DEFAULTS, ...given }, given));
      const byFlags = refuses(() => sequenceOptions(parseArguments([`--method=${method}`, ...words], COMPLETE)));
      expect([words, byFlags]).toEqual([words, byEngine]);
    }
  });

  it('leaves out what it lacks in a comparison and if it is inherited, and keeps the rest', () => {
    for (const [[one], [other]] of pairs) {
      const own = motionFor({ ...MOTION_DEFAULTS, ...one, ...other }, { method });
      expect(conflicts(own).filter((conflict) => conflict.other === 'method')).toEqual([]);
      const all = { ...MOTION_DEFAULTS, ...one, ...other, method };
      const { motion: inherited, warnings } = checkRules(all, { method });
      expect(conflicts(inherited)).toEqual([]);
      expect(warnings.length > 0).toBe(conflicts(all).length > 0);
      for (const { message } of warnings) expect(message).toMatch(/does not support .*\. The motion is made without /);
      for (const option of Object.keys(RULES) as RuledOption[])
        if (RULES[option].fitsMethod(all))
          expect(own[option]).toEqual({ ...MOTION_DEFAULTS, ...one, ...other }[option]);
    }
  });
});
