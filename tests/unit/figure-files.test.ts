/** The numbers of a figure, and the labels of its link. */
import { expect, it } from 'vitest';
import { chartNumbers } from '../../web/app/panels/chart-numbers.ts';
import { thinnedRows } from '../../web/app/panels/figure-files.ts';
import { plainColour } from '../../web/plots/plot-files.ts';
import { readPermalink, writePermalink } from '../../web/app/sources/permalink.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import type { Presented } from '../../web/model/state.ts';

const times = Array.from({ length: 97 }, (_, i) => i / 96);

it('numbers of a chart: a row per time, a column per curve, empty if unknown', () => {
  const numbers = chartNumbers({
    times,
    keyTimes: [0, 0.5, 1],
    range: [0, 1],
    series: [
      { label: 'a', values: times.map((t) => 2 * t), style: '' },
      { label: 'b', values: [1], style: '' },
    ],
  });
  expect(numbers.names).toEqual(['Time', 'a', 'b']);
  expect(numbers.rows[0]).toEqual([0, 0, 1]);
  expect(numbers.rows[48]).toEqual([0.5, 1, NaN]);
});

it('numbers of a chart with a choice of measures name the measure', () => {
  const series = [{ label: 'a', values: [1], style: '' }];
  const numbers = chartNumbers({ times: [0], keyTimes: [0], range: [0, 1], series, measure: 'by lengths' });
  expect(numbers.names).toEqual(['Time', 'a, by lengths']);
});

it('about two dozen rows are shown, including the keys', () => {
  const keep = [times[1]!, times[95]!];
  const read = thinnedRows({ names: ['Time'], rows: times.map((t) => [t]), keep }).map(([t]) => t);
  expect(read.length).toBeLessThanOrEqual(27);
  expect(read).toEqual(expect.arrayContaining(keep));
  expect(read).toEqual([...read].sort((a, b) => a! - b!));
});

it('a link restores the plots that always exist, and no others', () => {
  const linked = (present: Presented): string =>
    writePermalink(
      {
        ...EMPTY_STATE,
        source: { kind: 'sample', id: 'cactus' },
        view: { ...EMPTY_STATE.view, present },
      },
      EMPTY_STATE.doc,
    )!;
  expect(readPermalink(linked('volume'))?.view.present).toBe('volume');
  expect(linked('face-stretch')).not.toContain('present');
  expect(readPermalink('sample=cactus&present=face-stretch')?.unfit).toEqual(['present']);
});

it('colours of a saved image are readable by any program', () => {
  expect(plainColour('color(srgb 0.9 0.5 0 / 0.14)')).toEqual({ colour: 'rgb(230, 128, 0)', opacity: 0.14 });
  expect(plainColour('rgba(0, 114, 178, 0.5)')).toEqual({ colour: 'rgb(0, 114, 178)', opacity: 0.5 });
  expect(plainColour('rgb(0, 158, 115)')).toEqual({ colour: 'rgb(0, 158, 115)', opacity: 1 });
  expect(plainColour('none')).toEqual({ colour: 'none', opacity: 1 });
});
