/** When approximate shapes of files that are being opened are drawn, and what is open rests for it. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { SketchPlayer } from '../../web/app/playback/sketch-player.ts';
import type { Opening } from '../../web/app/session/workspace.ts';

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

const openingOf = (name: string): Opening => ({ info: { name }, doc: {}, pool: {} }) as unknown as Opening;
const at = (t: number) => ({
  t,
  positions: new Float32Array(3),
  normals: new Float32Array(3),
  faces: new Uint32Array(3),
});

/** A player on a machine that draws a shape in `ms`, with what it did. */
function playerOf(ms: number) {
  const log: string[] = [];
  const work = { fraction: 0.4 };
  const player = new SketchPlayer({
    show: (_, { t }, shadow) => void log.push(`show ${t}${shadow ? ' with its shadow' : ''}`),
    end: () => void log.push('end'),
    finished: () => new Promise((resolve) => setTimeout(resolve, ms)),
    rest: async () => void log.push('rest'),
    resume: () => void log.push('resume'),
    fraction: () => work.fraction,
    onChange: (shown) => void log.push(shown ? 'sketched' : 'not sketched'),
  });
  return { player, log, work };
}

describe('a sketch', () => {
  it('stays as long again as it took to draw where that is slow, and the newest comes next', async () => {
    const { player, log } = playerOf(100);
    const opening = openingOf('a');
    player.await(opening);
    player.take(opening, at(0));
    await vi.advanceTimersByTimeAsync(10);
    for (const t of [0.1, 0.2, 0.3]) player.take(opening, at(t));
    await vi.advanceTimersByTimeAsync(180);
    expect(log).toEqual(['rest', 'show 0', 'sketched']);
    await vi.advanceTimersByTimeAsync(20);
    expect(log.slice(3)).toEqual(['show 0.3']);
    expect(player.time).toBe(0.3);
  });

  it('follows at once where drawing is quick, with its shadow', async () => {
    const { player, log } = playerOf(10);
    const opening = openingOf('a');
    player.await(opening);
    for (const t of [0, 0.1, 0.2]) {
      player.take(opening, at(t));
      await vi.advanceTimersByTimeAsync(15);
    }
    expect(log).toEqual(['rest', 'show 0', 'sketched', 'show 0.1 with its shadow', 'show 0.2 with its shadow']);
  });

  it('is not begun any more when the work is nearly done', async () => {
    const { player, log, work } = playerOf(10);
    const opening = openingOf('a');
    player.await(opening);
    work.fraction = 0.9;
    player.take(opening, at(0));
    await vi.advanceTimersByTimeAsync(100);
    expect(log).toEqual(['rest']);
    player.end();
    expect(log).toEqual(['rest', 'resume']);
  });

  it('ends with what it is of: what was open is shown again, or what is open now is shown from its time on', async () => {
    for (const isOpened of [false, true]) {
      const { player, log } = playerOf(10);
      const opening = openingOf('a');
      player.await(opening);
      player.take(opening, at(0.7));
      await vi.advanceTimersByTimeAsync(20);
      expect(player.reached(opening.info)).toBe(0.7);
      expect(player.reached(openingOf('b').info)).toBeNull();
      if (isOpened) player.settle();
      else player.end();
      player.take(opening, at(0.8));
      await vi.advanceTimersByTimeAsync(1000);
      expect(log.slice(3)).toEqual([...(isOpened ? [] : ['end']), 'resume', 'not sketched']);
      expect(player.time).toBeNull();
      expect(player.reached(opening.info)).toBeNull();
    }
  });

  it('of what is opened next comes after that of what was given up, though that is still being drawn', async () => {
    const { player, log } = playerOf(100);
    const [one, two] = [openingOf('a'), openingOf('b')];
    player.await(one);
    player.take(one, at(0));
    await vi.advanceTimersByTimeAsync(10);
    player.end();
    player.await(two);
    player.take(two, at(0.5));
    await vi.advanceTimersByTimeAsync(1000);
    expect(log).toEqual([
      'rest',
      'show 0',
      'sketched',
      'end',
      'resume',
      'not sketched',
      'rest',
      'show 0.5',
      'sketched',
    ]);
  });
});
