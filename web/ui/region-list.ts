/** The regions of the shape with timings of their own: their colours, sizes and numbers. Hidden without regions. */
import type { TimingRegion } from '../engine/api/types.ts';
import { regionOfFaces } from '../model/timing-regions.ts';
import type { Colouring, Doc } from '../model/state.ts';
import { patchColour } from '../viewer/patch-colours.ts';
import { checkbox } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setHidden, svg } from './dom.ts';

export interface RegionListProps {
  doc: Doc;
  colouring: Colouring;
  /** Number of faces of the shape. */
  faces: number;
}

/** A row's plot, in pixels. */
const [WIDTH, HEIGHT] = [160, 20];
/** Pixels of the largest swing. */
const SWING_PX = HEIGHT / 2 / 1.5;

export function createRegionList(onColour: (regions: boolean) => void): Component<RegionListProps> {
  const colour = checkbox('Colour the regions', 'region-colours', onColour);
  const rows = h('ol', { class: 'regions' });
  const hint =
    'Each line shows one region, its share of the faces, and its timing. A dot to the left of the middle between ' +
    'two keys is earlier; a dot above the line swings out further.';
  const element = h(
    'div',
    { hidden: true, 'data-testid': 'regions' },
    colour.element,
    h(
      'details',
      { class: 'details' },
      h('summary', { 'data-testid': 'regions-open' }, 'Timing of the regions'),
      rows,
      h('p', { class: 'hint' }, hint),
    ),
  );
  const draw = memo(({ regions, keys, faces }: { regions: TimingRegion[]; keys: Doc['keys']; faces: number }) => {
    const regionOf = regionOfFaces(regions, faces);
    const times = keys.map(({ time }) => time);
    rows.replaceChildren(
      ...regions.map((region, index) => {
        const own = regionOf.reduce((sum, one) => sum + (one === index ? 1 : 0), 0);
        const name = region.faces.length === 0 ? 'position' : percent(own / faces);
        const swatch = h('span', { class: 'swatch', style: `--swatch: ${patchColour(index)}` });
        setHidden(swatch, region.faces.length === 0);
        return h('li', {}, swatch, h('span', { class: 'unit' }, name), plot(region, times));
      }),
    );
  });
  return {
    element,
    update({ doc: { motion, keys }, colouring, faces }) {
      const shown = motion.regions.length > 0 || colouring === 'regions';
      setHidden(element, !shown);
      if (!shown) return;
      colour.update(colouring === 'regions');
      draw({ regions: motion.regions, keys, faces });
    },
  };
}

/** A line through time with ticks at the keys, and a dot per interval. */
function plot({ earlier, swing }: TimingRegion, times: readonly number[]): SVGElement {
  const [start, end] = [times[0]!, times.at(-1)!];
  const x = (t: number): number => (WIDTH * (t - start)) / (end - start);
  const middle = HEIGHT / 2;
  const ticks = times.map((t) => svg('line', { x1: x(t), x2: x(t), y1: middle - 3, y2: middle + 3 }));
  const dots = times.slice(1).map((to, key) => {
    const from = times[key]!;
    const t = (from + to) / 2 - (earlier[key] ?? 0) * (to - from);
    return svg('circle', { cx: x(t), cy: middle - SWING_PX * (swing[key] ?? 0), r: 2 });
  });
  const line = svg('line', { x1: 0, x2: WIDTH, y1: middle, y2: middle });
  return svg('svg', { viewBox: `-3 -1 ${WIDTH + 6} ${HEIGHT + 2}`, 'aria-hidden': 'true' }, line, ...ticks, ...dots);
}

const percent = (share: number): string => `${(100 * share).toFixed(share < 0.0995 ? 1 : 0)} %`;
