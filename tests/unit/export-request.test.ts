import { describe, expect, it } from 'vitest';
import { DEFAULT_REQUEST, SIZES, exportNumbers, gridTimes, shareOf, sizeOf } from '../../web/model/export-request.ts';
import type { ExportRequest, Playing, VideoFormat } from '../../web/model/export-request.ts';

const WATCHED: Playing = { range: [0, 1], fps: null, speed: 0.25 };
const numbers = (request: Partial<ExportRequest>, playing: Partial<Playing> = {}, video: VideoFormat | null = null) =>
  exportNumbers({ ...DEFAULT_REQUEST, ...request }, { ...WATCHED, ...playing }, video);
const VIDEO = { animation: 'video' } as const;

describe('the request for an export', () => {
  it('has the duration of playback', () => {
    expect(numbers({})).toMatchObject({ seconds: 4, speed: 0.25, frames: 121, rate: 30 });
    expect(numbers(VIDEO, {}, 'mp4')).toMatchObject({ seconds: 4, frames: 120, rate: 30 });
    expect(numbers(VIDEO, { speed: 2, range: [1, 3] }, 'webm')).toMatchObject({ seconds: 1, frames: 30 });
    expect(numbers({ duration: 2 })).toMatchObject({ seconds: 2, speed: 0.5, frames: 61 });
  });

  it('has a separate duration for a turntable', () => {
    const turn = { kind: 'picture', picture: 'turntable' } as const;
    expect(numbers(turn, {}, 'mp4')).toMatchObject({ seconds: 6, frames: 180 });
    expect(numbers({ ...turn, turn: 2, duration: 9, bounce: true }, {}, 'mp4')).toMatchObject({ frames: 60 });
  });

  it('has consistent frames and frame rate, whichever was chosen', () => {
    expect(numbers({ frames: 60 })).toMatchObject({ frames: 60, rate: 14.75 });
    expect(numbers({ rate: 10 })).toMatchObject({ frames: 41, rate: 10 });
    expect(numbers({ rate: 1000, duration: 3600 }).frames).toBe(2000);
  });

  it('keeps the whole frames of the timeline', () => {
    const whole = numbers({}, { fps: 24, speed: 1, range: [0.5, 2] });
    expect(whole).toMatchObject({ frames: 37, rate: 24, whole: true });
    expect(gridTimes(whole)[0]).toBeCloseTo(0.5, 12);
    expect(gridTimes(whole).at(-1)).toBeCloseTo(2, 12);
    // Slower playback shows the same frames for longer.
    const slow = numbers({}, { fps: 24, speed: 0.5, range: [0.5, 2] });
    expect(slow).toMatchObject({ frames: 37, rate: 12, seconds: 3 });
    expect(gridTimes(slow)).toEqual(gridTimes(whole));
  });

  it('has the last frame of the timeline, and the frame rate of the animation by default', () => {
    const run = numbers({}, { fps: 24, speed: 1, range: [0, 0.7] });
    expect([run.frames, gridTimes(run).at(-1), gridTimes(run).length]).toEqual([18, 0.7, 18]);
    expect(numbers({}, { speed: 1, range: [0, 0.7], own: 24 })).toMatchObject({ frames: 18 });
    expect(numbers(VIDEO, { speed: 1, own: 24 }, 'mp4')).toMatchObject({ frames: 24, rate: 24 });
    expect(numbers(VIDEO, { speed: 1, own: 24 }, 'gif').rate).toBe(25);
  });

  it('has GIF frames of whole hundredths of a second', () => {
    expect(numbers(VIDEO, {}, 'gif')).toMatchObject({ frames: 100, rate: 25 });
    expect(numbers({ ...VIDEO, rate: 60 }, {}, 'gif').rate).toBe(50);
    expect(numbers({ ...VIDEO, rate: 120 }, {}, 'mp4').rate).toBe(60);
  });

  it('plays back and forth in twice the frames, without equal neighbours', () => {
    const { frames } = numbers({ ...VIDEO, bounce: true, duration: 0.1 }, {}, 'mp4');
    expect(frames).toBe(6);
    expect(numbers({ ...VIDEO, duration: 0.1 }, {}, 'mp4').frames).toBe(3);
    const shares = Array.from({ length: frames }, (_, frame) => shareOf(frame, frames, true));
    expect(shares).toEqual([0, 1 / 3, 2 / 3, 1, 2 / 3, 1 / 3]);
  });

  it('has the chosen size, that of the screen, or a small one for a GIF', () => {
    const size = (request: Partial<ExportRequest>, video: VideoFormat | null = null) =>
      sizeOf({ ...DEFAULT_REQUEST, ...request }, video);
    expect(size(VIDEO, 'mp4')).toBeNull();
    expect(size(VIDEO, 'gif')).toEqual(SIZES.small);
    expect(size({ ...VIDEO, videoSize: 'window' }, 'gif')).toBeNull();
    expect(size({ kind: 'picture', size: '4k' })).toEqual({ width: 3840, height: 2160 });
    expect(size({ kind: 'picture', size: 'own', own: { width: 7, height: 9 } })).toEqual({ width: 7, height: 9 });
  });

  it('has only the options of its kind', () => {
    const both = { ...DEFAULT_REQUEST, size: '4k', videoSize: 'square' } as const;
    expect(sizeOf({ ...both, kind: 'picture' }, null)).toEqual(SIZES['4k']);
    expect(sizeOf({ ...both, ...VIDEO }, 'mp4')).toEqual(SIZES.square);
  });
});
