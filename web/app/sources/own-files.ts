/** The user's files that can be reopened: the open ones, then those of this and of earlier visits. */
import { leadingName } from '../../ui/dropped-files.ts';
import type { AppState, Source } from '../../model/state.ts';
import type { ProjectOnShelf } from '../storage/project-shelf.ts';
import type { Sample } from './samples.ts';
import type { Snapshot } from '../storage/snapshot.ts';

export interface OwnFiles {
  /** Project id. */
  id: string;
  title: string;
}

/** Each project once: the open one first, then by time, newest first. */
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

/** Short title of the open content. */
export function sourceTitle(source: Source, samples: readonly Sample[]): string {
  if (source.kind === 'files') return filesTitle(source.names);
  return source.kind === 'sample' ? (samples.find(({ id }) => id === source.id)?.title ?? source.id) : '';
}

function filesTitle(names: readonly string[]): string {
  const first = leadingName(names);
  return names.length > 1 ? `${first} and ${names.length - 1} more` : first;
}
