import { describe, expect, it } from 'vitest';
import { PreviewTrust } from '../../web/playback/preview-trust.ts';
import type { TimeLine } from '../../web/playback/preview-trust.ts';
import type { PreviewError } from '../../web/engine/api/types.ts';

const line: TimeLine = { keyTimes: [0, 0.4, 1], range: [0, 1], periodic: false };
const within: PreviewError = { mean: 0.0009, largest: 0.0045 };

/** Measures all there is, nearest to t first, and says where. */
function measureAll(trust: PreviewTrust, t: number, off: (t: number) => PreviewError): number[] {
  const times: number[] = [];
  for (let sample = trust.next(t); sample; sample = trust.next(t)) {
    times.push(Number(sample.t.toFixed(9)));
    trust.note(sample, off(sample.t));
  }
  return times;
}

describe('trust in previews', () => {
  it('is unknown before a whole stretch was measured', () => {
    const trust = new PreviewTrust(line);
    for (let left = 3; left > 0; left -= 1) {
      expect(trust.closeAt(0.2)).toBeUndefined();
      trust.note(trust.next(0.2)!, within);
    }
    expect(trust.closeAt(0.2)).toBe(true);
    expect(trust.closeAt(0.6)).toBeUndefined();
  });

  it('begins where it is needed, and covers all that the slider reaches', () => {
    const trust = new PreviewTrust(line);
    const times = measureAll(trust, 0.7, () => within);
    expect(times.slice(0, 3)).toEqual([0.7, 0.55, 0.85]);
    expect(times).toHaveLength(2 * 3 + 2 * 4 * 3);
    expect([Math.min(...times), Math.max(...times)]).toEqual([-0.4, 1.4]);
    for (let t = -0.4; t <= 1.4; t += 0.013) expect(trust.closeAt(t), String(t)).toBe(true);
    expect(trust.closeAt(1.41)).toBe(false);
  });

  it('ends for a stretch with the first moment that is off, in the mean or at one place', () => {
    for (const bad of [
      { mean: 0.00092, largest: 0 },
      { mean: 0, largest: 0.0046 },
    ]) {
      const trust = new PreviewTrust(line);
      const times = measureAll(trust, 0.2, (t) => (t < 0.3 ? bad : within));
      expect(times.filter((t) => t > 0 && t < 0.4)).toEqual([0.2]);
      expect([0.01, 0.39].map((t) => trust.closeAt(t))).toEqual([false, false]);
      expect(trust.closeAt(0.41)).toBe(true);
    }
  });

  it('is freer beyond the keys, step by step outwards', () => {
    const trust = new PreviewTrust(line);
    measureAll(trust, 0, (t) => ({ mean: 0, largest: t > 1 ? (t - 1) / 5 : 0.004 }));
    expect([1.05, 1.15, 1.199, 1.25, 1.35].map((t) => trust.closeAt(t))).toEqual([true, true, true, false, false]);
    const strict = new PreviewTrust(line);
    measureAll(strict, 0, () => ({ mean: 0.005, largest: 0.02 }));
    expect([-0.2, 0.2, 1.2].map((t) => strict.closeAt(t))).toEqual([true, false, true]);
  });

  it('of a closed motion goes round', () => {
    const trust = new PreviewTrust({ keyTimes: [0, 0.4, 1], range: [0, 1.5], periodic: true });
    const times = measureAll(trust, 1.6, (t) => (t > 1 ? { mean: 1, largest: 1 } : within));
    expect(times[0]).toBe(0.2);
    expect(times.every((t) => t > 0 && t < 1.5)).toBe(true);
    expect([0.2, 1.2, 1.7, 2.9, -0.2, -0.9].map((t) => trust.closeAt(t))).toEqual([
      true,
      false,
      true,
      false,
      false,
      true,
    ]);
  });
});
