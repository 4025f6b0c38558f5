/** Bending energy of the shown motions by edge lengths and angles, one list per motion. */
import type { CallOptions } from '../../engine/api/api.ts';
import { partOf } from '../../engine/api/progress.ts';
import type { Analysis, AnalysisInput } from './analysis.ts';

export async function shellBendings(
  { sequences }: AnalysisInput,
  times: readonly number[],
  { signal, onProgress }: Required<CallOptions>,
): Promise<number[][]> {
  const energies: number[][] = [];
  for (const [index, { sequence }] of sequences.entries()) {
    const report = partOf(onProgress, index / sequences.length, (index + 1) / sequences.length);
    energies.push(await sequence.shellBending([...times], { signal, onProgress: report }));
  }
  return energies;
}

/** The analysis with these energies of its motions. */
export async function withShellBendings(
  analysis: Analysis,
  input: AnalysisInput,
  call: Required<CallOptions>,
): Promise<Analysis> {
  const energies = await shellBendings(input, analysis.times, call);
  return { ...analysis, motions: analysis.motions.map((motion, i) => ({ ...motion, shell: energies[i]! })) };
}
