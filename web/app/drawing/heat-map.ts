/** Colours the drawn shapes by amounts and shows the colour bar. */
import type { Frame, KeysInfo } from '../../engine/api/types.ts';
import { motionWords } from '../../model/method-words.ts';
import { isFaceAmount, referenceKey } from '../../model/state.ts';
import type { AppState, Colouring, Doc, FaceAmount } from '../../model/state.ts';
import type { ColourBarProps } from '../../ui/colour-bar.ts';
import type { Viewer } from '../../viewer/viewer.ts';
import type { FrameSet, RunningMotion } from '../../playback/frame-set.ts';
import type { PosePool } from '../session/pose-pool.ts';
import { differenceOf, heatColours, roundTop } from './difference.ts';
import type { Difference } from './difference.ts';
import { FaceHeat } from './face-heat.ts';
import { robustLargest } from './heat-range.ts';
import { besideOf, differing, wantsHeat } from './heat-wanted.ts';

const WORDS: Readonly<Record<FaceAmount, { title: string; unit: string; symbol: string; max: number }>> = {
  rotation: { title: 'Rotation', unit: 'of faces, relative to the reference', symbol: '°', max: 180 },
  stretch: { title: 'Stretch', unit: 'of faces, relative to the reference', symbol: '%', max: Infinity },
};

interface Heat {
  kind: Colouring | 'difference';
  /** The motion of the bar's range, which only grows while the motion stays the same. */
  of: RunningMotion['sequence'];
  top: number;
}

export class HeatMap {
  /** The current bar; null if no surface is coloured by amounts. */
  bar: ColourBarProps | null = null;
  /** The difference shown by the colours of the first view; null if they show none. */
  difference: Difference | null = null;
  private heat: Heat | null = null;
  /** The amounts of each view, in arrays reused for every frame. */
  private values: Float32Array[] = [];
  private colours: Float32Array[] = [];
  private faces: { pool: PosePool; pose: number; heat: FaceHeat } | null = null;

  constructor(private readonly viewer: Viewer) {}

  clear(): void {
    this.colours.forEach((_, view) => this.viewer.setHeatColours(null, view));
    this.heat = null;
    this.difference = null;
    this.bar = null;
    this.values = [];
    this.colours = [];
  }

  /** Colours the next frame. `original`: the source animation's shape, if shown. */
  show(
    { frames, sequences }: FrameSet,
    { view, doc }: AppState,
    info: KeysInfo,
    pool: PosePool,
    original: Float32Array | null,
  ): void {
    const [main] = sequences;
    if (!main || !wantsHeat(sequences, view)) return this.clear();
    const other = differing(sequences, view);
    const { colouring } = view;
    if (other >= 0) {
      this.showDifferences(frames, sequences, other, info.report.diagonal);
    } else if (colouring === 'distance') {
      this.showDistances(frames, sequences, original, info.report.diagonal);
    } else if (isFaceAmount(colouring)) {
      this.showFaces(frames, main, colouring, this.facesOf(doc, info, pool));
    }
  }

  /** Colours every shape with a ghost by its difference from the motion without one, if that is shown (Fig. 7). */
  private showDifferences(
    frames: readonly Frame[],
    sequences: readonly RunningMotion[],
    full: number,
    diagonal: number,
  ): void {
    const [main] = sequences;
    const views = [...sequences.keys()].filter((i) => sequences[i]!.ghost > 0 && sequences[i]!.method === main!.method);
    const unit = '% of the model’s size';
    const reference = frames[full]!.positions;
    this.difference = this.showApart(frames, views, reference, diagonal, main!, { kind: 'difference', unit });
  }

  /** Colours every shape by its distance from the reference: the animation, or else the first motion. */
  private showDistances(
    frames: readonly Frame[],
    sequences: readonly RunningMotion[],
    original: Float32Array | null,
    diagonal: number,
  ): void {
    const [main] = sequences;
    const first = original ? 0 : 1;
    if (!main || frames.length <= first) return this.clear();
    const word = (of: RunningMotion | undefined): string => (of ? motionWords(of).label : '');
    const from = original ? 'the animation' : word(main);
    const unit = `${word(sequences[first])} from ${from}, % of the model’s size`;
    const views = [...frames.keys()].slice(first);
    if (first === 1) this.viewer.setHeatColours(null, 0);
    const reference = original ?? frames[0]!.positions;
    this.showApart(frames, views, reference, diagonal, main, { kind: 'distance', unit });
  }

  /** Colours these views by each vertex's distance from the reference; returns the first view's distances. */
  private showApart(
    frames: readonly Frame[],
    views: readonly number[],
    reference: Float32Array,
    diagonal: number,
    { sequence }: RunningMotion,
    { kind, unit }: { kind: 'difference' | 'distance'; unit: string },
  ): Difference {
    const apart = views.map((view) => differenceOf(frames[view]!.positions, reference, diagonal, this.values[view]));
    const top = this.topOf(kind, sequence, Math.max(...apart.map(({ largest }) => largest)));
    views.forEach((view, i) => {
      const { percent } = apart[i]!;
      this.values[view] = percent;
      this.draw(view, percent, top);
    });
    const now = nowWords(apart[0]!, '\u00a0%');
    const title = kind === 'difference' ? 'Difference' : 'Distance';
    this.bar = { title, unit, symbol: '%', top, now, ...besideOf(this.viewer.rects()[views[0]!]!) };
    return apart[0]!;
  }

  /** Colours every shape, made by any method, by rotation or stretch. */
  private showFaces(frames: readonly Frame[], { sequence }: RunningMotion, kind: FaceAmount, heat: FaceHeat): void {
    this.difference = null;
    const amounts = frames.map(({ positions }, view) => heat.amounts(positions, kind, this.values[view]));
    const { title, unit, symbol, max } = WORDS[kind];
    const ends = amounts.map(({ values, largest }) => Math.min(robustLargest(values, largest), max));
    const top = Math.min(this.topOf(kind, sequence, Math.max(...ends)), max);
    amounts.forEach(({ values }, view) => {
      this.values[view] = values;
      this.draw(view, values, top);
    });
    const now = nowWords(amounts[0]!, symbol === '%' ? '\u00a0%' : symbol);
    const beyond = amounts.some(({ largest }) => largest > top);
    this.bar = { title, unit, symbol, top, beyond, now, ...besideOf(this.viewer.rects()[0]!) };
  }

  private topOf(kind: Heat['kind'], of: Heat['of'], largest: number): number {
    const before = this.heat?.kind === kind && this.heat.of === of ? this.heat.top : 0;
    if (this.heat && this.heat.kind !== kind) this.clear();
    const top = Math.max(before, roundTop(largest));
    this.heat = { kind, of, top };
    return top;
  }

  private draw(view: number, percent: Float32Array, top: number): void {
    const colours = heatColours({ percent }, top, this.colours[view]);
    this.colours[view] = colours;
    this.viewer.setHeatColours(colours, view);
  }

  private facesOf(doc: Doc, info: KeysInfo, pool: PosePool): FaceHeat {
    const pose = doc.keys[referenceKey(doc)]!.pose;
    if (this.faces?.pool !== pool || this.faces.pose !== pose)
      this.faces = { pool, pose, heat: new FaceHeat(pool.keys.positions(pose), info.faces) };
    return this.faces.heat;
  }
}

function nowWords({ largest, mean }: { largest: number; mean: number }, unit: string): string {
  const text = (value: number): string => `${Number(value.toPrecision(2))}${unit}`;
  return `at most ${text(largest)}, mean ${text(mean)}`;
}
