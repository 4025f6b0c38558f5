/** The shape plane in "What it sees": the curve is a matter of a millisecond and follows whatever changes it at once. */
import { DEFAULT_SPEED, MAX_SPEED, formatSpeed, offeredSpeed } from '../../model/speeds.ts';
import type { End } from '../../model/speeds.ts';
import { isInLri } from '../../model/state.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { createShapePlane } from '../../plots/shape-plane.ts';
import type { ShapePlaneData } from '../../plots/shape-plane.ts';
import { h, setHidden, setText } from '../../ui/dom.ts';
import { METHOD_WORDS } from '../../ui/motion-panel.ts';
import { SPEED_WORDS, typedSpeed } from '../../ui/speed-handles.ts';
import { isCancelled } from '../session/sequence-set.ts';
import type { RunningSequence } from '../session/sequence-set.ts';

export type Speeds = Readonly<Record<End, number>>;

export interface PlaneInput {
  sequences: readonly RunningSequence[];
  keyTimes: readonly number[];
  range: Range;
  /** Hermite: the key that tells the direction at an end, null where none does; null = another boundary. */
  towards: Readonly<Record<End, number | null>> | null;
}

export interface PlaneFigureEvents {
  onSpeed(end: End, speed: number): void;
  onError(error: unknown): void;
}

export interface PlaneFigure {
  element: HTMLElement;
  /** The curve has changed. */
  refresh(): void;
  setCursor(t: number): void;
  /** Hermite: the lengths of the handles at the ends; null = none. */
  setSpeeds(speeds: Speeds | null): void;
}

const POINTS = 97;
const TITLE = 'All keys as points in the plane that tells them apart best; distances in it are distances between shapes';

export function createPlaneFigure(input: () => PlaneInput | null, { onSpeed, onError }: PlaneFigureEvents): PlaneFigure {
  let speeds: Speeds | null = null;
  let cursor = 0;
  let stale = false;
  let running = false;

  // Several events can come before the page is drawn again: each goes on from what the one before has asked for.
  const set = (end: End, speed: number): void => {
    if (speeds) speeds = { ...speeds, [end]: speed };
    onSpeed(end, speed);
  };
  const plot = createShapePlane({
    most: MAX_SPEED, label: (end) => SPEED_WORDS[end].label, words: formatSpeed,
    onSpeed: (end, speed) => set(end, offeredSpeed(speed)),
    onReset: (end) => set(end, DEFAULT_SPEED),
    onKey(end, event) {
      const speed = typedSpeed(event, speeds?.[end] ?? DEFAULT_SPEED, end);
      if (speed === null) return;
      event.preventDefault();
      set(end, speed);
    },
  });
  const explained = h('span', { class: 'unit' });
  const element = h('figure', { class: 'figure', 'data-testid': 'plot-plane' },
    h('figcaption', { title: TITLE }, h('strong', {}, 'Shape plane'), explained), plot.element);

  const work = async (): Promise<void> => {
    const asked = input();
    if (!asked) return;
    const { keyTimes, range, towards } = asked;
    const sequences = asked.sequences.filter(({ method }) => isInLri(method));
    setHidden(element, sequences.length === 0);
    const times = plottedTimes(range, keyTimes, POINTS);
    const planes = await Promise.all(sequences.map(({ sequence }) => sequence.shapePlane(times)));
    const [main] = planes;
    if (!main) return;
    setText(explained, `holds ${(100 * main.explained).toFixed(0)} % of what differs between the keys`);
    plot.draw({
      times, range, keys: main.keys, tangents: towards && tangentsOf(main.keys, towards),
      curves: planes.map(({ curve }, index) => ({ label: METHOD_WORDS[sequences[index]!.method].label, points: curve, style: sequences[index]!.method })),
    });
    plot.setSpeeds(speeds);
    plot.setCursor(cursor);
  };

  const follow = async (): Promise<void> => {
    running = true;
    while (stale) {
      stale = false;
      await work().catch((error: unknown) => { if (!isCancelled(error)) onError(error); });
    }
    running = false;
  };

  return {
    element,
    refresh() {
      stale = true;
      if (!running) void follow();
    },
    setCursor(t) {
      cursor = t;
      plot.setCursor(t);
    },
    setSpeeds(next) {
      speeds = next;
      plot.setSpeeds(next);
    },
  };
}

/** A cubic of slope m over a time h has its second Bézier point a third of h m from its first: that is how far a handle goes. */
function tangentsOf(keys: readonly number[], towards: Readonly<Record<End, number | null>>): ShapePlaneData['tangents'] {
  const from = (key: number, target: number | null): [number, number] | null =>
    (target === null ? null : [0, 1].map((axis) => (keys[2 * target + axis]! - keys[2 * key + axis]!) / 3) as [number, number]);
  return { start: from(0, towards.start), end: from(keys.length / 2 - 1, towards.end) };
}
