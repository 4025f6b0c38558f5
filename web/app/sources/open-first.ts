/** What a visit starts with: what a link names, else what an earlier visit left, else the first sample. */
import type { OpenFiles } from './open-files.ts';
import { readPermalink } from './permalink.ts';
import type { RememberedFiles } from './remembered-files.ts';
import { fetchSamples } from './samples.ts';
import type { Sample } from './samples.ts';

export interface OpenFirstParts {
  files: OpenFiles;
  remembered: RememberedFiles;
  onSamples(samples: readonly Sample[]): void;
}

export async function openFirst({ files, remembered, onSamples }: OpenFirstParts): Promise<void> {
  const link = readPermalink(location.hash);
  const [samples, left] = await Promise.all([fetchSamples(), link ? null : remembered.recall()]);
  onSamples(samples);
  if (left && (await files.again(left))) return;
  const first = samples.find(({ id }) => id === link?.sample) ?? samples[0];
  if (!first) throw new Error('There are no samples beside this page. Open files of your own.');
  await files.sample(first.id, first.id === link?.sample ? link : null);
}
