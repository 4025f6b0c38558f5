/** Times when the first key of large files replaces the open shape, and when the open shape returns. */
import { describe, expect, it } from 'vitest';
import { FirstKey } from '../../web/app/drawing/first-key.ts';
import type { LoadedKeys } from '../../web/app/session/workspace.ts';

const openingOf = (name: string): LoadedKeys => ({ info: { name } }) as unknown as LoadedKeys;

function firstKeyOf() {
  const log: string[] = [];
  const firstKey = new FirstKey({
    rest: async () => void log.push('rest'),
    resume: () => void log.push('resume'),
    show: async ({ info }) => void log.push(`show ${(info as unknown as { name: string }).name}`),
    hide: () => void log.push('hide'),
    onSeen: (seen) => void log.push(seen),
  });
  return { firstKey, log };
}

describe('the first key', () => {
  it('is shown once playback has stopped, also if files turn out to be large only after reading', async () => {
    for (const begun of [true, false]) {
      const { firstKey, log } = firstKeyOf();
      if (begun) firstKey.begin();
      await firstKey.show(openingOf('a'));
      expect(log).toEqual([...(begun ? ['dimmed'] : []), 'rest', 'show a', 'first key']);
    }
  });

  it('is hidden if opening fails, and otherwise stays until its motion is ready', async () => {
    for (const isOpened of [true, false]) {
      const { firstKey, log } = firstKeyOf();
      firstKey.begin();
      await firstKey.show(openingOf('a'));
      if (isOpened) firstKey.settle();
      firstKey.end();
      expect(log.slice(4)).toEqual([...(isOpened ? [] : ['hide']), 'resume', 'open']);
      expect(firstKey.isShown).toBe(false);
    }
  });

  it('is not shown if something else is opened before playback has stopped', async () => {
    const { firstKey, log } = firstKeyOf();
    firstKey.begin();
    const given = firstKey.show(openingOf('a'));
    firstKey.end();
    firstKey.begin();
    await Promise.all([given, firstKey.show(openingOf('b'))]);
    expect(log).toEqual(['dimmed', 'rest', 'resume', 'open', 'dimmed', 'rest', 'show b', 'first key']);
  });
});
