/**
 * The initial content: from the link, else from an earlier visit, else the first sample. A first visit also shows the
 * page's purpose.
 */
import type { Offer } from '../../ui/messages.ts';
import { readSetting, writeSetting } from '../../ui/local-setting.ts';
import type { Opener } from './opener.ts';
import { guideLink, unknownLinkMessage } from './page-link.ts';
import { readPermalink } from './permalink.ts';
import type { StoredProject } from '../storage/project-shelf.ts';
import type { RememberedFiles } from '../storage/remembered-files.ts';
import { fetchSamples, makeSample } from './samples.ts';
import type { Sample } from './samples.ts';

const VISITED = 'shapespline.visited';
/**
 * Blended positions on the left of a divider, this method on the right. The time shows the difference without playback.
 */
const FIRST_SAMPLE = 'column';
const FIRST_VISIT = `sample=${FIRST_SAMPLE}&compare=linear&split=0.5&t=0.25&play=1`;

export interface OpenInitialParts {
  files: Opener;
  remembered: RememberedFiles;
  onSamples(samples: readonly Sample[]): void;
  say(text: string): void;
  /** The link names a page of the guide. */
  onGuide(fragment: string): Promise<unknown>;
  /** Opening these files failed before and may end this visit too, so the user decides whether to open them. */
  onStopped(offer: Offer): void;
}

/** `address`: the fragment, which may change before anything is open. */
export async function openInitial(
  { files, remembered, onSamples, say, onGuide, onStopped }: OpenInitialParts,
  address: () => string,
): Promise<void> {
  let asked = files.asks;
  const isOvertaken = (): boolean => files.asks !== asked;
  const isNew = readSetting(VISITED) === null;
  const begun = address();
  const made = isNew && opensFirstSample(begun) ? makeSample(FIRST_SAMPLE) : null;
  made?.catch(() => undefined); // The error is reported when the sample is opened.
  // Whether the user has changed the URL meanwhile.
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
  // Files dropped earlier are the content to restore.
  if (isChanged) await files.idle();
  onSamples(samples);
  if (isOvertaken()) return;
  const fragment = address();
  const named = readPermalink(fragment);
  const page = guideLink(fragment);
  if (page && ((await onGuide(page)) || isOvertaken())) return;
  const strange = named ? null : unknownLinkMessage(fragment);
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

/** Opens a stored project; null if another request replaces it. */
export function reopening(files: Opener): (project: StoredProject) => Promise<boolean | null> {
  return async (project) => {
    const opened = files.again(project);
    const { asks } = files;
    return (await opened) || (files.asks === asks ? false : null);
  };
}

const opensFirstSample = (fragment: string): boolean => !readPermalink(fragment) && !guideLink(fragment);
