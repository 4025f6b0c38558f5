/** What older versions wrote opens with the same state: links, projects, and documents that a browser has kept. */
import { describe, expect, it } from 'vitest';
import { docOf } from '../../web/app/session/document-from-import.ts';
import type { PosePool } from '../../web/app/session/workspace.ts';
import { applyPermalink, readPermalink, writePermalink } from '../../web/app/sources/permalink.ts';
import { readOptions, writeProject } from '../../web/engine/wire/project.ts';
import type { KeysInfo } from '../../web/engine/api/types.ts';
import { partTurnsOf, shapingOf } from '../../web/model/edits.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, EMPTY_STATE } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';
import saved from './fixtures/saved.json';

const initial: Doc = {
  keys: [{ pose: 0, name: 'a', time: 0 }, { pose: 1, name: 'b', time: 0.5 }, { pose: 2, name: 'c', time: 1 }],
  motion: { ...DEFAULT_MOTION }, encoding: { ...DEFAULT_ENCODING }, tension: [], bias: [], turns: [], partTurns: [],
};

/** The document as the fixtures spell it, whatever it is made of. */
function spelt(doc: Doc): object {
  const [tension, bias, turns] = (['tension', 'bias', 'turns'] as const).map((name) => shapingOf(doc, name));
  const keys = doc.keys.map(({ pose, name, time }, key) =>
    ({ pose, name, time, tension: tension![key], bias: bias![key], turns: turns![key], partTurns: partTurnsOf(doc)[key] }));
  return { keys, motion: doc.motion, encoding: doc.encoding };
}

/** Poses that a project brings along are numbered after its three keys. */
function poolOf(): PosePool {
  let last = 2;
  return { add: () => ++last } as unknown as PosePool;
}

describe('what older versions saved', () => {
  it.each(saved.links)('opens from the link $link', ({ link, ...expected }) => {
    const doc = applyPermalink(initial, readPermalink(link)!);
    expect(spelt(doc)).toEqual(expected);
    expect(writePermalink({ ...EMPTY_STATE, source: { kind: 'sample', id: 'cactus' }, doc, time: 0.25 }, initial)).toBe(link);
  });

  it.each(saved.projects)('opens from a project: $text', ({ text, options: { startTangent, ...options }, ...expected }) => {
    const project = readOptions(text)!;
    expect(project).toEqual({ ...options, startTangent: startTangent && Float32Array.from(startTangent) });
    const { keys } = JSON.parse(text) as { keys: { times: number[]; names: string[]; frames: number[] } };
    expect(spelt(docOf({ names: keys.names, times: keys.times, project } as unknown as KeysInfo, poolOf()))).toEqual(expected);
    expect(JSON.parse(writeProject(keys, project))).toEqual(JSON.parse(text));
  });
});
