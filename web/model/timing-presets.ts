/** Usual timings of the interval after a key. */
import type { IntervalNumber } from './shaping.ts';

export type Timing = Readonly<Record<IntervalNumber, number>>;

export const TIMINGS: readonly { id: string; label: string; hint: string; timing: Timing }[] = [
  { id: 'smooth', label: 'Smooth', hint: 'As smooth as possible', timing: { earlier: 0, swing: 0 } },
  { id: 'earlier', label: 'Earlier', hint: 'Ahead in the middle', timing: { earlier: 0.2, swing: 0 } },
  { id: 'later', label: 'Later', hint: 'Behind in the middle', timing: { earlier: -0.2, swing: 0 } },
  { id: 'straight', label: 'Straight', hint: 'The mean of both keys in the middle', timing: { earlier: 0, swing: -1 } },
  { id: 'overshoot', label: 'Overshoot', hint: 'Swings out half as far again', timing: { earlier: 0, swing: 0.5 } },
];

/** For a sentence. */
export function timingName({ earlier, swing }: Timing): string {
  const usual = TIMINGS.find(({ timing }) => timing.earlier === earlier && timing.swing === swing);
  return usual?.label.toLowerCase() ?? 'own numbers';
}
