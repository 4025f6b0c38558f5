/**
 * What a visit starts with: what a link names, else what an earlier visit left, else the first sample; a first visit
 * with what the page is for.
 */
import type { Offer } from '../../ui/messages.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Opener } from './opener.ts';
import { guideLink, strangeLink } from './page-link.ts';
import { readPermalink } from './permalink.ts';
import type { StoredProject } from '../kept/project-shelf.ts';
import type { RememberedFiles } from '../kept/remembered-files.ts';
import { fetchSamples, makeSample } from './samples.ts';
import type { Sample } from './samples.ts';

const VISITED = 'shapespline.visited';
/** Blended positions on the left of a divider, this method on its right; at a time that tells even if nothing moves. */
const FIRST_SAMPLE = 'column';
const FIRST_VISIT = `sample=${FIRST_SAMPLE}&compare=linear&split=0.5&t=0.25&play=1`;

export interface OpenInitialParts {
  files: Opener;
  remembered: RememberedFiles;
  onSamples(samples: readonly Sample[]): void;
  say(text: string): void;
  /** The link names a page of the guide. */
  onGuide(fragment: string): Promise<unknown>;
  /** These files did not open before. They may end this visit, too, so they are opened on demand. */
  onStopped(offer: Offer): void;
}

/** `address`: the fragment, which may change before there is something to open. */
export async function openInitial(
  { files, remembered, onSamples, say, onGuide, onStopped }: OpenInitialParts,
  address: () => string,
): Promise<void> {
  let asked = files.asks;
  const isOvertaken = (): boolean => files.asks !== asked;
  const isNew = readSetting(VISITED) === null;
  const begun = address();
  const made = isNew && opensFirstSample(begun) ? makeSample(FIRST_SAMPLE) : null;
  made?.catch(() => undefined); // said where it is opened
  // What the address is changed to meanwhile comes after what was asked for until then.
  let isChanged = false;
  const onAddress = (): void => {
    const named = address();
    if (named === begun || opensFirstSample(named)) return;
    isChanged = true;
    asked = files.asks;
  };
  window.addEventListener('hashchange', onAddress);
  const [samples, kept] = await Promise.all([fetchSamples(), remembered.recall()]).finally(() =>
    window.removeEventListener('hashchange', onAddress),
  );
  // The files that were dropped before are what is given back.
  if (isChanged) await files.idle();
  onSamples(samples);
  if (isOvertaken()) return;
  const fragment = address();
  const named = readPermalink(fragment);
  const page = guideLink(fragment);
  if (page && ((await onGuide(page)) || isOvertaken())) return;
  const strange = named ? null : strangeLink(fragment);
  if (strange) say(strange);
  const again = async (project: StoredProject): Promise<boolean | null> => {
    if (isOvertaken()) return null;
    asked += 1;
    return reopening(files)(project);
  };
  const [left] = named ? [] : kept;
  if (left?.opening) {
    onStopped({
      message: `“${left.names[0] ?? 'A file'}” was not reopened, because the last attempt failed or did not finish.`,
      action: 'Open it',
      onAccept: () => void remembered.reopen(left.id, reopening(files)),
    });
  } else if (left) {
    if ((await remembered.reopen(left.id, again).catch(() => false)) || isOvertaken()) return;
    say(`“${left.names[0] ?? 'A file'}” could not be reopened. A sample is shown instead.`);
  }
  const link = named ?? (isNew && !left ? readPermalink(FIRST_VISIT) : null);
  const first = samples.find(({ id }) => id === link?.sample) ?? samples[0];
  if (!first) throw new Error('This page has no samples. Open your own files.');
  const input = first.id === FIRST_SAMPLE ? made : null;
  const opened = await files.sample(first.id, first.id === link?.sample ? link : null, input);
  if (opened && !named) writeSetting(VISITED, '1');
  if (named && named.sample !== first.id)
    say(`There is no sample named “${named.sample}”. “${first.title}” is shown instead. Choose another under Samples.`);
}

/** Opens what was kept; null where something else is asked for before it is there. */
export function reopening(files: Opener): (project: StoredProject) => Promise<boolean | null> {
  return async (project) => {
    const opened = files.again(project);
    const { asks } = files;
    return (await opened) || (files.asks === asks ? false : null);
  };
}

const opensFirstSample = (fragment: string): boolean => !readPermalink(fragment) && !guideLink(fragment);
