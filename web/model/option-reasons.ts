/** Why options, or some of their choices, cannot be used with the document's method and other options. */
import { conflicts, hasEffect } from '../engine/api/rules.ts';
import { OPTION_WORDS } from './option-words.ts';
import type { WordedOption } from './option-words.ts';
import { ruledOptions } from './spline-options.ts';
import type { Edited } from './spline-options.ts';

/** By choice. */
export type Reasons = Readonly<Record<string, string>>;

/** The reason why an option has no effect; '' if it has one. */
export function reasonFor(name: WordedOption, { motion }: Pick<Edited, 'motion'>): string {
  return hasEffect(name, motion) ? '' : `This method does not use ${OPTION_WORDS[name].label.toLowerCase()}.`;
}

export function reasonsForChoices(name: WordedOption, edited: Edited): Reasons {
  const words = OPTION_WORDS[name].choices ?? {};
  const all = reasonFor(name, edited);
  const options = ruledOptions(edited);
  const excluded = Object.keys(words).flatMap((choice) => {
    const value = typeof options[name as never] === 'number' ? Number(choice) : choice;
    const reason = all || exclusion(name, { ...options, [name]: value });
    return reason === null ? [] : [{ choice, reason }];
  });
  const lacking = excluded.filter(({ reason }) => reason === '').map(({ choice }) => words[choice]!.label);
  const lack = `This method does not support ${lacking.join(' or ')}.`;
  return Object.fromEntries(excluded.map(({ choice, reason }) => [choice, reason || lack]));
}

/** The words of the option that excludes this one; '' if the method does, null if none does. */
function exclusion(name: WordedOption, options: ReturnType<typeof ruledOptions>): string | null {
  for (const { option, other } of conflicts(options)) {
    if (option === name && other === 'method') return '';
    if (other === name) return OPTION_WORDS[option].excludes ?? '';
  }
  return null;
}
