/**
 * What a visit starts with: what a link names, else what an earlier visit left, else the first sample; a first visit
 * with what the page is for.
 */
import type { Offer } from '../../ui/messages.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { OpenFiles } from './open-files.ts';
import { guideLink, strangeLink } from './page-link.ts';
import { readPermalink } from './permalink.ts';
import type { RememberedFiles } from '../kept/remembered-files.ts';
import { fetchSamples, makeSample } from './samples.ts';
import type { Sample } from './samples.ts';

const VISITED = 'shapespline.visited';
/** Blended positions on the left of a divider, this method on its right; at a time that tells even if nothing moves. */
const FIRST_SAMPLE = 'column';
const FIRST_VISIT = `sample=${FIRST_SAMPLE}&compare=linear&split=0.5&t=0.25&play=1`;

export interface OpenFirstParts {
  files: OpenFiles;
  remembered: RememberedFiles;
  onSamples(samples: readonly Sample[]): void;
  say(text: string): void;
  /** The link names a page of the guide. */
  onGuide(fragment: string): Promise<unknown>;
  /**
   * An earlier visit ended while it opened these files: they may end this one, too, so that they are opened on demand.
   */
  onStopped(offer: Offer): void;
}

export async function openFirst(
  { files, remembered, onSamples, say, onGuide, onStopped }: OpenFirstParts,
  fragment: string,
): Promise<void> {
  const named = readPermalink(fragment);
  const page = guideLink(fragment);
  const isFirstVisit = !named && readSetting(VISITED) === null;
  const made = isFirstVisit && !page ? makeSample(FIRST_SAMPLE) : null;
  made?.catch(() => undefined); // said where it is opened
  const [samples, kept] = await Promise.all([fetchSamples(), remembered.recall()]);
  onSamples(samples);
  if (page && (await onGuide(page))) return;
  const strange = named ? null : strangeLink(fragment);
  if (strange) say(strange);
  if (!named) writeSetting(VISITED, '1');
  const [left] = named ? [] : kept;
  if (left?.opening) {
    onStopped({
      message: `“${left.names[0] ?? 'A file'}” was not opened again: the last visit ended while it was being opened.`,
      action: 'Open it',
      onAccept: () => void remembered.reopen(left.id, files.again),
    });
  } else if (left && (await remembered.reopen(left.id, files.again).catch(() => false))) return;
  const link = named ?? (isFirstVisit && !left ? readPermalink(FIRST_VISIT) : null);
  const first = samples.find(({ id }) => id === link?.sample) ?? samples[0];
  if (!first) throw new Error('This page has no samples. Open your own files.');
  await files.sample(first.id, first.id === link?.sample ? link : null, first.id === FIRST_SAMPLE ? made : null);
  if (named && named.sample !== first.id)
    say(`There is no sample named “${named.sample}”. This is “${first.title}”; choose another under Samples.`);
}
