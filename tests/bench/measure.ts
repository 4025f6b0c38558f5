/** Measures one generated mesh: every stage of building its sequence, then single frames. Runs in browser and Node. */
import type { Engine } from '../../web/engine/api/api.ts';
import { bandwidthReader } from './bandwidth.ts';
import { buildRepeatedly, Listener, refitGrowth, type Builds, type Silence } from './builds.ts';
import type { RunNative } from './native-round.ts';
import { errorsOf, type Errors, type Reference } from './errors.ts';
import { exactFrames, roundOf, type ExactFrames, type Round } from './frames.ts';
import { createWithGhost, ghostFrames, type GhostFrames } from './ghost-frames.ts';

/** Size of the paper's ghost, and number of shapes to time it with. */
const GHOST_FACES = 2000,
  GHOST_SHAPES = 12;

/** Measurements in milliseconds and bytes. */
export interface Run {
  faces: number;
  vertices: number;
  importMs: number;
  importSilence: Silence;
  builds: Builds;
  exact: ExactFrames;
  /** For `shapes` shapes; null if the mesh is hardly larger than the ghost. */
  withGhost: (GhostFrames & { shapes: number }) | null;
  /** Heap after many refits over the heap after one. */
  refitGrowth: number;
  heapBytes: number;
  factorBytes: number;
  errors: Errors;
}

export interface Input {
  name: string;
  mesh: Uint8Array;
  reference: Reference;
  /** The module that measures memory bandwidth. */
  reader: BufferSource;
  runNative: RunNative;
  /** Bytes of the whole process, or NaN. */
  processBytes: () => number;
}

export async function measure(
  engine: Engine,
  { name, mesh, reference, reader, runNative, processBytes }: Input,
): Promise<Run> {
  const start = performance.now();
  const listener = new Listener();
  const keys = await engine.importKeyframes([{ name, bytes: mesh }], {}, { onProgress: listener.onProgress });
  listener.hear('end');
  const importMs = performance.now() - start;
  const readBandwidth = await bandwidthReader(reader);
  const rounds: Round[] = [];
  const { sequence, builds } = await buildRepeatedly(engine, keys, processBytes, async (built, buildMs) => {
    rounds.push(await roundOf(built, buildMs, readBandwidth, runNative));
  });
  const { vertices, faces } = keys.info.report;
  const withGhost = faces > 2 * GHOST_FACES ? await createWithGhost(engine, keys, GHOST_FACES) : null;
  const errors = await errorsOf(sequence, withGhost?.sequence ?? null, reference);
  const growth = await refitGrowth(sequence);
  const { heapBytes, factorBytes } = await sequence.stats();
  sequence.dispose();
  const ghostTimes = withGhost && { ...(await ghostFrames(withGhost, GHOST_SHAPES)), shapes: GHOST_SHAPES };
  withGhost?.sequence.dispose();
  return {
    faces,
    vertices,
    importMs,
    importSilence: listener.silence,
    builds,
    exact: exactFrames(rounds),
    withGhost: ghostTimes,
    refitGrowth: growth,
    // The import's memory was the first build's heap.
    heapBytes: Math.max(builds.heapBytes, heapBytes),
    factorBytes,
    errors,
  };
}
