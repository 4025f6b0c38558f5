/**
 * Images of the times that the mouse points at on the timeline. They are made one at a time, for the newest time, when
 * drawing is idle. Slow images wait until the pointer rests and are not made during playback.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { Frame } from '../../engine/api/types.ts';

export interface TimePicturesParts {
  /** The first running sequence. */
  sequence(): Motion | undefined;
  isPlaying(): boolean;
  /** Resolves when drawing is idle. */
  idle(): Promise<void>;
  draw(frame: Frame): string;
  onPicture(url: string | null): void;
}

export interface TimePictures {
  /** Requests an image of the time under the pointer; null when the pointer leaves. */
  want(t: number | null): void;
  /** The motion or the look changed, so earlier images are outdated. */
  forget(): void;
}

/** Times closer than this share of the range share one image. */
const STEP = 1 / 200;
const MAX_KEPT = 64;
/** Longest drawing time of an image, in milliseconds, while the motion plays. */
const PLAYING_MS = 8;
/** Longest drawing time of an image, in milliseconds, before the pointer has rested for REST_MS. */
const MOVING_MS = 24;
const REST_MS = 160;

export function createTimePictures(parts: TimePicturesParts): TimePictures {
  const kept = new Map<number, string>();
  let wanted: number | null = null;
  let running = false;
  let cost = 0;
  let shown: string | null = null;

  const show = (url: string | null): void => {
    if (url === shown) return;
    shown = url;
    parts.onPicture(url);
  };
  const placeOf = (t: number): number => {
    const [first, last] = parts.sequence()?.range ?? [0, 1];
    return Math.round(t / (STEP * (last - first)));
  };

  const make = async (t: number): Promise<void> => {
    const sequence = parts.sequence();
    if (!sequence) return;
    const [frame] = await sequence.evaluateMany([t]);
    if (!frame) return;
    await parts.idle();
    if (sequence === parts.sequence() && wanted !== null) {
      const start = performance.now();
      const url = parts.draw(frame);
      cost = performance.now() - start;
      if (kept.size >= MAX_KEPT) kept.delete(kept.keys().next().value!);
      kept.set(placeOf(t), url);
      if (wanted !== null && placeOf(wanted) === placeOf(t)) show(url);
    }
    frame.release();
  };

  const rested = async (): Promise<void> => {
    for (let t = wanted; ; t = wanted) {
      await new Promise((resolve) => setTimeout(resolve, REST_MS));
      if (t === wanted) return;
    }
  };

  const work = async (): Promise<void> => {
    while (wanted !== null && !kept.has(placeOf(wanted))) {
      if (cost > PLAYING_MS && parts.isPlaying()) return;
      if (cost > MOVING_MS) await rested();
      if (wanted !== null && !kept.has(placeOf(wanted))) await make(wanted);
    }
  };

  return {
    want(t) {
      wanted = t;
      if (t === null) return;
      const known = kept.get(placeOf(t));
      if (known !== undefined) return show(known);
      if (running) return;
      running = true;
      // The next pointer movement requests an image from the replaced sequence's successor.
      void work()
        .catch(() => undefined)
        .finally(() => {
          running = false;
        });
    },
    forget() {
      kept.clear();
      show(null);
    },
  };
}
