/** The user's own files that can be gone back to: those that are open, of this visit, and of earlier ones. */
import { leadingName } from '../../ui/dropped-files.ts';
import type { AppState, Source } from '../../model/state.ts';
import type { ProjectOnShelf } from '../kept/project-shelf.ts';
import type { Sample } from './samples.ts';
import type { Snapshot } from '../kept/snapshot.ts';

export interface OwnFiles {
  /** The project. */
  id: string;
  title: string;
}

/** Each project once: what is open first, then what was left last. */
export function ownFiles(
  { source, project }: AppState,
  earlier: readonly Snapshot[],
  shelf: readonly ProjectOnShelf[],
): OwnFiles[] {
  const titles = new Map<string, string>();
  const add = (id: string | null, names: readonly string[]): void => {
    if (id !== null && !titles.has(id)) titles.set(id, filesTitle(names));
  };
  if (source.kind === 'files') add(project, source.names);
  for (const { state } of earlier) {
    if (state.source.kind === 'files') add(state.project, state.source.names);
  }
  for (const { id, names } of shelf) add(id, names);
  return [...titles].map(([id, title]) => ({ id, title }));
}

/** What is open in a few words. */
export function sourceTitle(source: Source, samples: readonly Sample[]): string {
  if (source.kind === 'files') return filesTitle(source.names);
  return source.kind === 'sample' ? (samples.find(({ id }) => id === source.id)?.title ?? source.id) : '';
}

function filesTitle(names: readonly string[]): string {
  const first = leadingName(names);
  return names.length > 1 ? `${first} and ${names.length - 1} more` : first;
}
