/**
 * The queries that the core answers: plain data in, plain data out. A query needs only one line here between its
 * binding (wasm/bindings) and its method.
 */
import type {
  DiscretePath,
  FaceCurve,
  Ghost,
  KeySpacing,
  MeasuresAt,
  MotionSpeed,
  PatchCurve,
  SequenceStats,
  ShapePlane,
  TimingDerivatives,
} from '../api/types.ts';

/** Urgency of a request: shown before ahead, and ahead before exports and measures. */
export type Urgency = 'shown' | 'ahead' | 'batch';

interface Query<Of, Input, Answer> {
  /** The wasm module's function, which takes a handle and JSON. */
  symbol: string;
  of: Of;
  urgency: Urgency;
  /** Never set at run time; carries the types. */
  types?: (input: Input) => Answer;
}

const ofMotion = <Input extends object, Answer>(
  symbol: string,
  urgency: Urgency = 'shown',
): Query<'motion', Input, Answer> => ({ symbol, of: 'motion', urgency });

const ofShape = <Input extends object, Answer>(symbol: string): Query<'shape', Input, Answer> => ({
  symbol,
  of: 'shape',
  urgency: 'shown',
});

export const QUERIES = {
  /** `shape`: positions of another motion's shape at the only time, which is placed in the plane instead. */
  plane: ofMotion<{ times: number[]; shape: Float32Array | null }, ShapePlane>('_shapespline_plane'),
  discretePath: ofMotion<{ samples: number }, DiscretePath>('_shapespline_discrete_path'),
  faceCurve: ofMotion<{ face: number; times: number[] }, FaceCurve>('_shapespline_face_curve'),
  patchCurve: ofMotion<{ patch: number; times: number[] }, PatchCurve>('_shapespline_patch_curve'),
  keySpacing: ofMotion<object, KeySpacing>('_shapespline_key_spacing'),
  motionSpeed: ofMotion<{ times: number[] }, MotionSpeed>('_shapespline_motion_speed', 'batch'),
  bending: ofMotion<{ times: number[] }, { energy: number[] }>('_shapespline_bending'),
  ghostPositions: ofMotion<{ t: number }, { positions: Float32Array }>('_shapespline_ghost_positions'),
  timingDerivatives: ofMotion<{ t: number; regionOf: number[] }, TimingDerivatives>(
    '_shapespline_timing_derivatives',
    'batch',
  ),
  /** Measures at least one of these times, and more of them within `maxMs`. */
  measure: ofMotion<{ times: number[]; maxMs: number }, MeasuresAt>('_shapespline_measure', 'batch'),
  /** The component of each face; -1 without area. */
  components: ofShape<object, { componentOf: Int32Array }>('_shapespline_components'),
  patches: ofShape<object, { patchOf: Int32Array }>('_shapespline_patches'),
  ghost: ofShape<object, Ghost>('_shapespline_ghost'),
  stats: ofShape<object, Omit<SequenceStats, 'threads' | 'heapBytes'>>('_shapespline_stats'),
};

export type QueryName = keyof typeof QUERIES;
export type QueryInput<N extends QueryName> = Parameters<NonNullable<(typeof QUERIES)[N]['types']>>[0];
export type QueryResult<N extends QueryName> = ReturnType<NonNullable<(typeof QUERIES)[N]['types']>>;
