/** Controls of options: bounds of the table, words for every option of the page, and reasons from the rules. */
import { describe, expect, it } from 'vitest';
import { METHODS } from '../../web/engine/api/methods.ts';
import { ENCODING, MOTION, PER_KEY, optionsIn } from '../../web/engine/api/option-table.ts';
import type { NumberOption } from '../../web/engine/api/option-table.ts';
import { checkRules } from '../../web/engine/api/options.ts';
import { MOTION_DEFAULTS } from '../../web/engine/api/types.ts';
import { setMotion, setShaping, setTurns } from '../../web/model/edits.ts';
import { reasonFor, reasonsForChoices } from '../../web/model/option-reasons.ts';
import { OPTION_WORDS } from '../../web/model/option-words.ts';
import type { WordedOption } from '../../web/model/option-words.ts';
import type { Doc, Motion } from '../../web/model/state.ts';
import { numberBounds } from '../../web/ui/option-field.ts';
import { docOfKeys, keyRef } from './documents.ts';

const plain = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
const withMotion = (change: Partial<Motion>): Doc => setMotion(plain, change);

const rows = [MOTION, ENCODING, PER_KEY].flatMap(optionsIn) as [WordedOption, NumberOption][];
const numbers = rows.filter(([name, { kind }]) => kind === 'number' && name in OPTION_WORDS);

describe.each(numbers)('the field of %s', (name, { min, max, whole }) => {
  const bounds = numberBounds(name);
  const { slider = [max, max], choices } = OPTION_WORDS[name];

  it('has the bounds of the table, and its slider ends within them', () => {
    expect([bounds.min, bounds.max]).toEqual([min, max]);
    for (const end of slider) expect(end >= (min ?? -Infinity) && end <= max).toBe(true);
    expect(whole ? Number.isInteger(bounds.step) : true).toBe(true);
    expect(bounds.step === 'any').toBe(!whole && slider[0] === slider[1]);
  });

  it('offers only choices within the bounds', () => {
    for (const choice of Object.keys(choices ?? {}))
      expect(Number(choice) >= (min ?? 0) && Number(choice) <= max).toBe(true);
  });
});

it('the choices of an option with words are those of the table', () => {
  for (const [name, { choices }] of Object.entries(OPTION_WORDS) as [WordedOption, { choices?: object }][]) {
    const option = rows.find(([one]) => one === name)![1] as { choices?: readonly string[] };
    if (choices && option.choices) expect([name, ...Object.keys(choices)]).toEqual([name, ...option.choices]);
  }
});

describe('a choice is disabled with a reason', () => {
  it('if and only if the engine refuses these ends with the method', () => {
    for (const method of METHODS)
      for (const boundary of MOTION.boundary.choices) {
        const refused = ((): boolean => {
          try {
            checkRules({ ...MOTION_DEFAULTS, method, boundary }, { method, boundary });
            return false;
          } catch {
            return true;
          }
        })();
        const reason = reasonsForChoices('boundary', withMotion({ method }))[boundary];
        expect([method, boundary, reason !== undefined]).toEqual([method, boundary, refused]);
      }
  });

  it('which names the choices that the method does not support', () => {
    const reason = (method: Motion['method']): string | undefined =>
      reasonsForChoices('boundary', withMotion({ method }))['hermite'];
    expect(reason('geodesic')).toBe('This method does not support Ease.');
    expect(reason('lengths')).toBe('This method does not support Ease or Loop.');
  });

  it('which names the option that excludes it', () => {
    const reasons = (doc: Doc): object => reasonsForChoices('keepLengths', doc);
    const all = (reason: string): object => ({ 1: reason, 2: reason, 3: reason });
    expect(reasons(plain)).toEqual({});
    expect(reasons(withMotion({ boundary: 'periodic' }))).toEqual(all('Requires free ends.'));
    expect(reasons(withMotion({ hold: 'on' }))).toEqual(all('Not with parts held in place.'));
    expect(reasons(setTurns(plain, 1, { turns: 1 }))).toEqual(all('Not with extra turns.'));
  });

  it('but not if another option gives way', () => {
    expect(reasonsForChoices('boundary', withMotion({ keepLengths: 1 }))).toEqual({});
  });
});

it('an option without effect has a reason and keeps its value', () => {
  const doc = setShaping(withMotion({ method: 'lengths' }), 'tension', 1, 0.5);
  expect(reasonFor('tension', doc)).toBe('This method does not use tension.');
  expect(doc.keys[1]!.shaping.tension).toBe(0.5);
  expect(reasonFor('tension', plain)).toBe('');
  expect(reasonsForChoices('stretch', withMotion({ method: 'linear' }))['log']).toBe(
    'This method does not use stretch.',
  );
});
