/** What is marked on the shape: the place of a warning, a separate part, or where faces have turned inside out. */
import type { Sequence } from '../../engine/api/api.ts';
import type { Warning } from '../../engine/api/types.ts';
import { keysInWords, keysOf } from '../../engine/api/warning-keys.ts';
import { length } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { WarningItem } from '../../ui/warnings.ts';
import type { Context } from '../context.ts';

export interface Marking {
  /** Marks the place of a warning and goes to its moment; null ends that. */
  warning(index: number | null): void;
  /** Marks a component; null ends that. */
  part(component: number | null): void;
  /** Marks what moves with a face. */
  around(face: number): void;
  /** The motion is another one now: a place that was marked may be none any more. Parts stay what they are. */
  follow(): void;
}

type Find = (sequence: Sequence) => Promise<number[]>;

export function createMarking(context: Context, seek: (t: number) => void): Marking {
  const { picture, workspace } = context;
  let newest = 0;
  let ofPart = false;

  const mark = (find: Find | null): void => {
    newest += 1;
    const mine = newest;
    const [running] = workspace.sequences;
    if (!find || !running) return picture.viewer.setMark(null);
    find(running.sequence).then((faces) => {
      if (mine === newest && workspace.sequences[0]?.sequence === running.sequence) picture.viewer.setMark(faces.length > 0 ? faces : null);
    }).catch(context.fail);
  };

  return {
    warning(index) {
      const warning = index === null ? undefined : context.viewState().warnings[index];
      context.inform({ shownWarning: warning ? index : null });
      ofPart = false;
      mark(warning && hasPlace(warning) ? (sequence) => facesOf(sequence, warning.patches, warning.face) : null);
      const t = warning && momentOf(warning, context.store.get().doc.keys.map(({ time }) => time), context.range());
      if (t !== undefined && t !== null) seek(t);
    },
    part(component) {
      context.inform({ shownWarning: null });
      ofPart = component !== null;
      mark(component === null ? null : async (sequence) => where(await sequence.components(), (part) => part === component));
    },
    around(face) {
      context.inform({ shownWarning: null });
      ofPart = false;
      mark((sequence) => facesOf(sequence, [], face));
    },
    follow() {
      if (ofPart) return;
      context.inform({ shownWarning: null });
      mark(null);
    },
  };
}

/** The faces of the patches; of the face's own where there are none. */
async function facesOf(sequence: Sequence, patches: readonly number[], face: number): Promise<number[]> {
  const ofFace = await sequence.patches();
  const wanted = new Set(patches.length > 0 ? patches : [ofFace[face] ?? -1]);
  return where(ofFace, (patch) => patch >= 0 && wanted.has(patch));
}

function where(values: Int32Array, fits: (value: number) => boolean): number[] {
  const indices: number[] = [];
  values.forEach((value, index) => { if (fits(value)) indices.push(index); });
  return indices;
}

function hasPlace({ patches, face }: Warning): boolean {
  return patches.length > 0 || face >= 0;
}

/** The middle of the interval that a warning is about, or its key's time; null where it is about no moment. */
export function momentOf(warning: Warning, keyTimes: readonly number[], range: Range): number | null {
  const keys = keysOf(warning, keyTimes.length);
  if (!keys) return null;
  const [from, to] = keys.map((key) => keyTimes[key]);
  if (from === undefined || to === undefined) return null;
  // A closed motion comes back to its first key one period later.
  return (from + (to < from ? to + length(range) : to)) / 2;
}

export function warningItems(warnings: readonly Warning[], keys: number): WarningItem[] {
  return warnings.map((warning) => ({
    code: warning.code, message: warning.message, where: keysInWords(warning, keys), shows: hasPlace(warning) || warning.key >= 0,
  }));
}
