/** Markers on the shape: a warning's faces, a component, or indefinite faces. */
import type { Motion } from '../../engine/api/api.ts';
import type { Warning } from '../../engine/api/types.ts';
import { keysOf } from '../../engine/api/warning-keys.ts';
import { length } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { WarningItem } from '../../ui/warnings.ts';
import type { SceneController } from './scene-controller.ts';

export interface MarkingParts {
  scene: SceneController;
  /** The first running sequence. */
  sequence(): Motion | undefined;
  warnings(): readonly Warning[];
  keyTimes(): number[];
  range(): Range;
  seek(t: number): void;
  /** Reports the index of the marked warning. */
  onWarning(index: number | null): void;
  onError(error: unknown): void;
}

export interface Marking {
  /** Marks a warning's faces and goes to its time; null removes the marker. */
  warning(index: number | null): void;
  /** Marks a component; null removes the marker. */
  component(component: number | null): void;
  /** Marks the region that moves with a face. */
  around(face: number): void;
  patches(patches: readonly number[]): void;
  /** The motion changed, so a marked face or patch may no longer exist. Components stay the same. */
  follow(): void;
}

type Find = (sequence: Motion) => Promise<number[]>;

export function createMarking({
  scene,
  sequence,
  warnings,
  keyTimes,
  range,
  seek,
  onWarning,
  onError,
}: MarkingParts): Marking {
  let newest = 0;
  let ofComponent = false;

  const mark = (find: Find | null): void => {
    newest += 1;
    const mine = newest;
    const asked = sequence();
    if (!find || !asked) return scene.viewer.setMark(null);
    find(asked)
      .then((faces) => {
        if (mine === newest && sequence() === asked) scene.viewer.setMark(faces.length > 0 ? faces : null);
      })
      .catch(onError);
  };

  return {
    warning(index) {
      const warning = index === null ? undefined : warnings()[index];
      onWarning(warning ? index : null);
      ofComponent = false;
      mark(warning && hasPlace(warning) ? (of) => facesOf(of, warning.patches, warning.face) : null);
      const t = warning && momentOf(warning, keyTimes(), range());
      if (t !== undefined && t !== null) seek(t);
    },
    component(component) {
      onWarning(null);
      ofComponent = component !== null;
      mark(
        component === null ? null : async (of) => where(await of.shape.components(), (value) => value === component),
      );
    },
    around(face) {
      onWarning(null);
      ofComponent = false;
      mark((of) => facesOf(of, [], face));
    },
    patches(patches) {
      onWarning(null);
      ofComponent = false;
      mark((of) => facesOf(of, patches, -1));
    },
    follow() {
      if (ofComponent) return;
      onWarning(null);
      mark(null);
    },
  };
}

/** The faces of the patches, or of the face's own patch if the list is empty. */
async function facesOf(sequence: Motion, patches: readonly number[], face: number): Promise<number[]> {
  const ofFace = await sequence.shape.patches();
  const wanted = new Set(patches.length > 0 ? patches : [ofFace[face] ?? -1]);
  return where(ofFace, (patch) => patch >= 0 && wanted.has(patch));
}

function where(values: Int32Array, fits: (value: number) => boolean): number[] {
  const indices: number[] = [];
  values.forEach((value, index) => {
    if (fits(value)) indices.push(index);
  });
  return indices;
}

function hasPlace({ patches, face }: Warning): boolean {
  return patches.length > 0 || face >= 0;
}

/** The middle of a warning's interval, or its key's time; null for warnings without a time. */
export function momentOf(warning: Warning, keyTimes: readonly number[], range: Range): number | null {
  const keys = keysOf(warning, keyTimes.length);
  if (!keys) return null;
  const [from, to] = keys.map((key) => keyTimes[key]);
  if (from === undefined || to === undefined) return null;
  // A closed motion returns to its first key one period later.
  return (from + (to < from ? to + length(range) : to)) / 2;
}

export function warningItems(warnings: readonly Warning[]): WarningItem[] {
  return warnings.map((warning) => ({
    code: warning.code,
    message: warning.message,
    shows: hasPlace(warning) || warning.key >= 0,
  }));
}
