/** The page's sentences and its demonstration agree with its figures. */
import { describe, expect, it } from 'vitest';
import { SCENES } from '../../../web/play/demonstration.ts';
import { derive } from '../../../web/play/derived.ts';
import { bendingNotice, curveNotice, rateNotice, systemNotice, weightsNotice } from '../../../web/play/notices.ts';
import { bendingNumbers, curveNumbers, systemNumbers, weightNumbers } from '../../../web/play/numbers.ts';
import { valueAt } from '../../../web/play/splines/curve.ts';
import { INITIAL, LAYERS, withKey } from '../../../web/play/state.ts';
import type { PlayState } from '../../../web/play/state.ts';

const of = (state: PlayState) => ({ state, derived: derive(state) });

describe('the notices', () => {
  it('distinguish corners from jumps of the second derivative', () => {
    const straight = of({ ...INITIAL, layers: ['linear', 'natural', 'catmull-rom'] });
    expect(rateNotice(straight.state, straight.derived, 1)).toMatch(
      /corners, .*: Straight lines\..*: Natural cubic, Catmull-Rom/,
    );
    expect(rateNotice(straight.state, straight.derived, 2)).toMatch(
      /jerk, .*: Straight lines, Catmull-Rom\..*: Natural cubic/,
    );
    const smooth = of(INITIAL);
    expect(rateNotice(smooth.state, smooth.derived, 1)).toMatch(/no corner/);
    expect(rateNotice(smooth.state, smooth.derived, 2)).toMatch(/No second derivative jumps.*what “natural” means/);
  });

  it('state the influence of a key beyond its neighbours', () => {
    const { state, derived } = of(INITIAL);
    const percent = Number(/at most ([\d.]+) %/.exec(curveNotice(state, derived, 'key'))![1]);
    const beyond = [0.02, 0.1, 0.14, 0.2, 0.8, 0.9].map((t) => Math.abs(valueAt(derived.weights[2]!, t)));
    expect(percent / 100).toBeGreaterThanOrEqual(Math.max(...beyond) - 1e-3);
    expect(percent).toBeLessThan(25);
  });

  it('state that tension and bias change a slope, and are empty without them', () => {
    const plain = of(INITIAL);
    expect(curveNotice(plain.state, plain.derived, 'shaping')).toMatch(
      /slope at key \d+ is that of the natural spline/,
    );
    const { selected } = INITIAL;
    const keys = INITIAL.keys.map((key, index) => (index === selected ? { ...key, tension: 0.5 } : key));
    const shaped = of({ ...INITIAL, keys });
    expect(curveNotice(shaped.state, shaped.derived, 'shaping')).toMatch(/Tension 0\.5 and bias 0 change the slope/);
  });

  it('compare the total bending, which is least for the natural spline', () => {
    const { state, derived } = of({ ...INITIAL, layers: ['natural', 'hermite', 'periodic', 'catmull-rom'] });
    const times = [...bendingNotice(state, derived).matchAll(/([\d.]+) times/g)].map(([, n]) => Number(n));
    expect(times).toHaveLength(3);
    for (const one of times) expect(one).toBeGreaterThan(1);
  });

  it('explain a row under the pointer, and state the sum of the weights at the time', () => {
    const { state, derived } = of(INITIAL);
    expect(systemNotice(state, derived, 0)).toMatch(/second derivative at key 1 is 0/);
    expect(systemNotice(state, derived, 2)).toMatch(/both sides of key 3/);
    const said = weightsNotice(state, derived);
    const terms = [...said.matchAll(/(−)? ?([\d.]+) × key/g)].map(([, minus, n]) => (minus ? -1 : 1) * Number(n));
    expect(terms.reduce((sum, term) => sum + term)).toBeCloseTo(1, 2);
    expect(Number(/= (−?[\d.]+)\. The/.exec(said)![1])).toBeCloseTo(valueAt(derived.curves.natural[0]!, 0.4), 2);
  });
});

describe('the tables', () => {
  it('contain the curves, their derivatives, weights, system and bending', () => {
    const { state, derived } = of({ ...INITIAL, layers: ['linear', 'natural'], plane: true });
    const { names, rows, brief } = curveNumbers(state, derived, 0);
    expect(names).toHaveLength(5);
    expect(brief.filter((_, i) => i % 2 === 0).map((row) => row[3])).toEqual(state.keys.map(({ value }) => value));
    expect(rows).toHaveLength(201);
    expect(weightNumbers(derived).brief[4]).toEqual([0.5, 0, 0, 1, 0, 0]);
    expect(systemNumbers(derived).rows[1]!.slice(0, 4)).toEqual([2, 4, 16, 4]);
    expect(bendingNumbers(derived).rows[0]).toHaveLength(LAYERS.length);
    expect(curveNumbers(state, derived, 2).rows[100]).toHaveLength(3);
  });
});

describe('times by distance', () => {
  it('are proportional to the distances between the keys', () => {
    const wide = withKey(INITIAL, 0, { value: 5 });
    const { times } = derive({ ...wide, spacing: 'difference' });
    expect(times[1]).toBeGreaterThan(0.6);
    expect([times[0], times[4]]).toEqual([0, 1]);
    expect(derive({ ...wide, spacing: 'root' }).times[1]).toBeLessThan(times[1]!);
  });
});

describe('the demonstration', () => {
  it.each(SCENES.map((scene, index) => [index + 1, scene] as const))(
    'scene %i moves and can be shown at any moment',
    (_, scene) => {
      const states = [0, 0.1, 0.35, 0.6, 0.999].map(scene.at);
      expect(new Set(states.map((state) => JSON.stringify(state))).size).toBeGreaterThan(2);
      for (const state of states) {
        const derived = derive(state);
        expect(curveNotice(state, derived, scene.lastAction).length).toBeGreaterThan(30);
        // Within a column, no curve bends less than the natural spline.
        for (const layer of state.layers)
          expect(derived.bending[layer] / derived.bending.natural).toBeGreaterThan(1 - 1e-9);
      }
    },
  );
});
