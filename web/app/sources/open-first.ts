/** What a visit starts with: what a link names, else what an earlier visit left, else the first sample. */
import type { Offer } from '../../ui/messages.ts';
import type { OpenFiles } from './open-files.ts';
import { readPermalink } from './permalink.ts';
import type { RememberedFiles } from './remembered-files.ts';
import { fetchSamples } from './samples.ts';
import type { Sample } from './samples.ts';

export interface OpenFirstParts {
  files: OpenFiles;
  remembered: RememberedFiles;
  onSamples(samples: readonly Sample[]): void;
  /**
   * An earlier visit ended while it opened these files: they may end this one, too, so that they are opened on demand.
   */
  onStopped(offer: Offer): void;
}

export async function openFirst({ files, remembered, onSamples, onStopped }: OpenFirstParts): Promise<void> {
  const link = readPermalink(location.hash);
  const [samples, kept] = await Promise.all([fetchSamples(), remembered.recall()]);
  onSamples(samples);
  const [left] = link ? [] : kept;
  if (left?.opening) {
    onStopped({
      message: `“${left.names[0] ?? 'A file'}” was not opened again: the last visit ended while it was being opened.`,
      action: 'Open it',
      onAccept: () => void remembered.reopen(left.id, files.again),
    });
  } else if (left && (await remembered.reopen(left.id, files.again).catch(() => false))) return;
  const first = samples.find(({ id }) => id === link?.sample) ?? samples[0];
  if (!first) throw new Error('This page has no samples. Open your own files.');
  await files.sample(first.id, first.id === link?.sample ? link : null);
}
