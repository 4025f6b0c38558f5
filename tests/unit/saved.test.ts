/** What commit 4f00d434 wrote opens with the same state: links, projects, and documents stored by a browser. */
import { describe, expect, it } from 'vitest';
import { documentFromImport } from '../../web/app/session/document-from-import.ts';
import type { PosePool } from '../../web/app/session/pose-pool.ts';
import { applyPermalink, readPermalink, writePermalink } from '../../web/app/sources/permalink.ts';
import { goneOptions, readOptions, writeProject } from '../../web/engine/wire/project.ts';
import { ENCODING, MOTION, PER_KEY } from '../../web/engine/api/option-table.ts';
import { SEQUENCE_DEFAULTS, type KeysInfo } from '../../web/engine/api/types.ts';
import { goneIn, goneSentence, withoutGone } from '../../web/engine/api/gone-options.ts';
import { storedDocument } from '../../web/model/stored-document.ts';
import { turnsOf } from '../../web/model/shaping.ts';
import { DEFAULT_MOTION, EMPTY_STATE } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';
import saved from '../saved/links-and-projects.json';

const initial = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 0.5), keyRef(2, 'c', 1));

/** The document in the form of the fixtures. */
function spelt(doc: Doc): object {
  const keys = doc.keys.map(({ pose, name, time, shaping }) => ({
    pose,
    name,
    time,
    tension: shaping.tension,
    bias: shaping.bias,
    turns: turnsOf(shaping),
    partTurns: shaping.turns.filter(({ component }) => component !== undefined),
  }));
  return { keys, motion: doc.motion, encoding: doc.encoding };
}

/** The text without the option that is gone. */
const asNow = (text: string): string => text.replace(/&ownPaths=\w+/, '').replace(/"ownPaths":"\w+",/, '');

/** Fields missing in a fixture were added later and have their defaults. */
const withDefaults = <T extends { motion: object }>(expected: T): T => ({
  ...expected,
  motion: { ...DEFAULT_MOTION, ...withoutGone(expected.motion) },
});

/** Poses included in a project are numbered after its three keys. */
function poolOf(): PosePool {
  let last = 2;
  return { add: () => ++last } as unknown as PosePool;
}

describe('links and documents of commit 4f00d434', () => {
  it.each(saved.links)('open from the link $link, and as stored by a browser', ({ link, document, ...expected }) => {
    const doc = applyPermalink(initial, readPermalink(link)!);
    expect(spelt(doc)).toEqual(withDefaults(expected));
    expect(storedDocument(document as Parameters<typeof storedDocument>[0])).toEqual(doc);
    expect(writePermalink({ ...EMPTY_STATE, source: { kind: 'sample', id: 'cactus' }, doc, time: 0.25 }, initial)).toBe(
      asNow(link),
    );
  });

  it('drop an option that is gone, and name it if it was in use', () => {
    const unfit = (value: string): string[] => readPermalink(`sample=cactus&ownPaths=${value}`)!.unfit;
    expect([unfit('root'), unfit('off')]).toEqual([['ownPaths'], []]);
    const project = (ownPaths: string): string[] => goneOptions(JSON.stringify({ options: { ownPaths } }));
    expect([project('absolute'), project('off'), goneOptions('no JSON')]).toEqual([['ownPaths'], [], []]);
    expect(goneSentence(project('absolute'))).toMatch(/own paths of faces/);
    const stored = { keys: [], motion: { ...DEFAULT_MOTION, ownPaths: 'root' } };
    expect(storedDocument(stored).motion).toEqual(DEFAULT_MOTION);
    expect(goneIn(stored.motion)).toEqual(['ownPaths']);
  });

  it('are stored here for every option of a link', () => {
    const options = [...Object.values(MOTION), ...Object.values(ENCODING)].flatMap((one) =>
      'page' in one ? one.page : [],
    );
    const later = ['earlier', 'swing', 'regions']; // options added after that commit
    const names = [...options, ...Object.keys(PER_KEY)].filter((name) => !later.includes(name));
    const kept = saved.links.flatMap(({ link }) => [...new URLSearchParams(link).keys()]);
    expect(names.filter((name) => !kept.includes(name))).toEqual([]);
  });

  it.each(saved.projects)(
    'opens from a project: $text',
    ({ text, options: { startTangent, ...options }, ...expected }) => {
      const project = readOptions(text)!;
      expect(project).toEqual({
        ...SEQUENCE_DEFAULTS,
        ...options,
        startTangent: startTangent && Float32Array.from(startTangent),
      });
      const { keys } = JSON.parse(text) as { keys: { times: number[]; names: string[]; frames: number[] } };
      expect(
        spelt(documentFromImport({ names: keys.names, times: keys.times, project } as unknown as KeysInfo, poolOf())),
      ).toEqual(withDefaults(expected));
      expect(JSON.parse(writeProject(keys, project, { vertices: 3, faces: 1, error: null }))).toMatchObject(
        JSON.parse(asNow(text)) as object,
      );
    },
  );
});
