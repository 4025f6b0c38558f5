/**
 * Motions of the methods `lengths` and `shell`, and of the option `keepLengths`. Creating one fits shapes between the
 * keys. The motion is then a motion in LRI space through the keys and the fitted shapes, which are the keys of a
 * derived shape. Loaded on first use.
 */
import type { CallOptions, Motion } from '../api/api.ts';
import { EngineError, invalidOption, untilAborted } from '../api/errors.ts';
import { METHOD, OWN_METHOD, fitCount } from '../api/methods.ts';
import { partOf } from '../api/progress.ts';
import { NO_PLACE, type EncodingOptions, type Ghost, type MotionOptions, type Warning } from '../api/types.ts';
import type { KeyData, MotionSpec, RequestOf, ResultOf } from '../wire/protocol.ts';
import { fitTimes, type FitTime } from './fit-times.ts';
import { MotionClient, type MotionParts } from './motion.ts';
import { meanBending } from './shell-bending.ts';
import type { ShapeClient } from './shape.ts';
import { UserKeys } from './user-keys.ts';
import type { ShellsWorker } from './worker-client.ts';

/** Fitting a coarse mesh with more faces takes too long. */
const MAX_COARSE = 4000;

/** Largest number of keys and fitted shapes. */
const MAX_MOTION_KEYS = 2000;

/** Progress when the starts are ready, the shapes fitted, the motion through them made, and its bending measured. */
const STARTED = 0.3;
const FITTED = 0.7;
const MADE = 0.9;
const COMPARED = 0.95;

/** Smallest share by which a motion must bend more than LRI's to be named. */
const NOTICEABLE = 0.01;

type Sample = RequestOf<'fitShells'>['samples'][number];
type Report = NonNullable<CallOptions['onProgress']>;
type Call = CallOptions & { onProgress: Report };

/** The mesh that is fitted, with its keys and the starts of the fits. */
interface Coarse {
  faces: Uint32Array;
  keys: Float32Array[];
  samples: Sample[];
}

/** Fits a motion of `shape` with the options and times of `spec`. */
export async function fitMotion(shape: ShapeClient, spec: MotionSpec, call: CallOptions = {}): Promise<MotionParts> {
  shape.checkAlive();
  checkCount(spec.options, spec.keyTimes.length);
  const full = { signal: call.signal, onProgress: call.onProgress ?? (() => undefined) } as Call;
  const worker = shape.parts.shellsWorker();
  const end = (): void => worker.terminate(invalidOption('The fit has ended.'));
  try {
    const fit = new Fit(shape, spec, worker, full);
    return await untilAborted(call.signal, fit.run());
  } finally {
    end();
  }
}

/** Rejects end tangents, which are options of the encoding, if no other motions use the shape. */
export function refuseTangents({ method }: MotionOptions, { startTangent, endTangent }: EncodingOptions): void {
  if (!startTangent && !endTangent) return;
  throw invalidOption(
    METHOD[method].curve === 'fitted'
      ? `The method '${method}' does not support end tangents. Use the method '${OWN_METHOD}'.`
      : 'The option keepLengths does not support end tangents. Set keepLengths to 0.',
  );
}

/** Counts the shapes before any is fitted, because fits may take minutes. */
function checkCount(options: MotionOptions, keys: number): void {
  const { method, keepLengths } = options;
  const shapes = fitCount(keys, options);
  if (keys + shapes <= MAX_MOTION_KEYS) return;
  const count = (n: number): string => Math.floor(n).toLocaleString('en');
  const isMethod = METHOD[method].curve === 'fitted';
  const each = isMethod ? 1 : keepLengths;
  const fewer = isMethod
    ? "Use the method 'lri'"
    : `Set keepLengths to ${count((MAX_MOTION_KEYS - keys) / (keys - 1))}`;
  throw new EngineError(
    'too-large',
    `With ${isMethod ? `the method '${method}'` : `keepLengths ${keepLengths}`}, ${count(keys)} keys need ` +
      `${count(shapes)} shapes between them, but a motion can have at most ${count(MAX_MOTION_KEYS)} keys and shapes ` +
      `in all. ${fewer}, or use at most ${count((MAX_MOTION_KEYS + each) / (each + 1))} keys.`,
  );
}

class Fit {
  private readonly times: FitTime[];
  private readonly report: Report;

  constructor(
    private readonly shape: ShapeClient,
    private readonly spec: MotionSpec,
    private readonly worker: ShellsWorker,
    private readonly call: Call,
  ) {
    this.times = fitTimes(spec.keyTimes, spec.options);
    this.report = call.onProgress;
  }

  async run(): Promise<MotionParts> {
    const faces = this.shape.parts.keys.info.faces.length / 3;
    const ghosted = faces > this.spec.options.spaceFaces ? await this.encodeGhost() : null;
    try {
      const base = await (ghosted ?? this.shape).motion(this.startOptions(), this.part(ghosted ? 0.2 : 0, STARTED));
      const ghost = ghosted && (await ghosted.ghost());
      const fitted = ghost ? await this.fitGhost(base, ghost) : await this.fitWhole(base);
      const open = base.warnings.filter(({ code }) => code.startsWith('ambiguous-'));
      base.dispose();
      return await this.motionThrough(fitted, open);
    } finally {
      ghosted?.dispose();
    }
  }

  /** A warning if the shape spline bends less: fits on a coarse mesh may lose more than they gain. */
  private async compare(motion: Motion): Promise<Warning[]> {
    const plain = await this.shape.motion(this.startOptions());
    try {
      const bendingOf = (one: Motion, call: Call): Promise<number> =>
        meanBending(
          this.shape.parts.keys,
          { range: one.range, frame: async (t) => (await one.evaluateMany([t]))[0]! },
          this.worker,
          call,
        );
      const [own, lri] = [
        await bendingOf(motion, this.part(MADE, COMPARED)),
        await bendingOf(plain, this.part(COMPARED, 1)),
      ];
      return own > (1 + NOTICEABLE) * lri ? [bendsMore(own / lri - 1)] : [];
    } finally {
      plain.dispose();
    }
  }

  /** Encodes the shape with a ghost mesh, which becomes the coarse mesh. */
  private encodeGhost(): Promise<ShapeClient> {
    const { keys, encoding } = this.shape.parts;
    const leading = { ghostFaces: this.spec.options.spaceFaces, transfer: 'exact', placement: 'vertices' } as const;
    return this.shape.derive(keys, { ...withoutTangents(encoding), ...leading }, this.part(0, 0.2));
  }

  /** Options of the motion in LRI space that provides the starts of the fits and the weights of the splined lengths. */
  private startOptions(): object {
    const { tension, bias } = this.spec.options;
    return { method: 'lri', keyTimes: [...this.spec.keyTimes], tension, bias };
  }

  private async fitWhole(base: Motion): Promise<Fitted> {
    const { positions, info } = this.shape.parts.keys;
    const starts = await this.starts(async (t) => this.frameAt(base, t));
    return this.fit({ faces: info.faces, keys: [...positions], samples: await this.samples(base, starts) });
  }

  private async fitGhost(base: Motion, ghost: Ghost): Promise<Fitted> {
    if (ghost.faces.length / 3 > MAX_COARSE)
      throw invalidOption(
        `The shape cannot be simplified enough: its coarse mesh still has ${(ghost.faces.length / 3).toLocaleString('en')} ` +
          `faces, and at most ${MAX_COARSE.toLocaleString('en')} can be fitted. Choose another method.`,
      );
    const { info, positions } = this.shape.parts.keys;
    const keys: Float32Array[] = [];
    for (const t of this.spec.keyTimes) keys.push(await base.ghostPositions(t));
    const starts = await this.starts((t) => base.ghostPositions(t));
    const coarse = { faces: ghost.faces, keys, samples: await this.samples(base, starts) };
    const { shapes, ...rest } = await this.fit(coarse);
    const leader = { faces: ghost.faces, vertexOf: ghost.ghostVertexOf, faceOf: ghost.ghostFaceOf };
    await this.worker.call('deformationTransfer', { faces: info.faces, keys: [...positions], leader });
    const led: Float32Array[] = [];
    for (const { time, key } of this.times) {
      if (key >= 0) {
        led.push(positions[key]!);
        continue;
      }
      const shape = await this.frameAt(base, time);
      const [from, to] = [starts[led.length]!, shapes[led.length]!];
      led.push((await this.worker.call('follow', { shape, from, to })).positions);
    }
    return { shapes: led, ...rest };
  }

  private async fit({ faces, keys, samples }: Coarse): Promise<Fitted> {
    const method = this.spec.options.method === 'shell' ? 'shell' : 'lengths';
    return this.worker.call('fitShells', { method, faces, keys, samples }, this.part(STARTED, FITTED));
  }

  /** The starts of the fits, one per time; null at a key. */
  private async starts(at: (t: number) => Promise<Float32Array>): Promise<(Float32Array | null)[]> {
    const starts: (Float32Array | null)[] = [];
    for (const { time, key } of this.times) {
      if (this.call.signal?.aborted) break;
      starts.push(key >= 0 ? null : await at(time));
    }
    return starts;
  }

  private async samples(base: Motion, starts: (Float32Array | null)[]): Promise<Sample[]> {
    const keys = this.spec.keyTimes.length;
    const fitted = this.times.flatMap(({ time, key }) => (key < 0 ? [time] : []));
    const { weights } = fitted.length > 0 ? await base.shapePlane(fitted) : { weights: [] };
    const columns = weights.length / fitted.length;
    let from = 0;
    // Arrays of numbers would take the page a while to send.
    const next = (): Float64Array => {
      const own = Float64Array.from(weights.slice(from, from + keys));
      from += columns;
      return own;
    };
    return this.times.map(({ time, key }, i) => ({ time, key, start: starts[i]!, weights: key < 0 ? next() : null }));
  }

  private async frameAt(motion: Motion, t: number): Promise<Float32Array> {
    const [frame] = await motion.evaluateMany([t]);
    const positions = frame!.positions.slice();
    frame!.release();
    return positions;
  }

  /** `open`: warnings about the user's keys. Between fitted shapes, rotations may be too small for them. */
  private async motionThrough(
    { shapes, failed, stiff, finished }: Fitted,
    open: readonly Warning[],
  ): Promise<MotionParts> {
    const { keys, encoding } = this.shape.parts;
    const at = (key: number): number => this.times.findIndex((one) => one.key === key);
    const next = (from: number): number => this.times.slice(from).find(({ key }) => key >= 0)!.key;
    const through: KeyData = {
      ...keys,
      info: {
        ...keys.info,
        times: this.times.map(({ time }) => time),
        names: this.times.map(({ time, key }) => keys.info.names[key] ?? `${time}`),
      },
      positions: shapes.map((shape, i) => keys.positions[this.times[i]!.key] ?? shape),
      userKeys: this.times.map((_, i) => next(i)),
    };
    const options = { ...withoutTangents(encoding), reference: at(encoding.reference) };
    const derived = await this.shape.derive(through, options, this.part(FITTED, 0.8));
    try {
      const { inPlace } = this.spec.options;
      const spec = derived.spec(
        { ...this.spec.options, method: 'lri', keepLengths: 0, tension: [], bias: [], inPlace },
        through.info.times,
      );
      const state = await derived.make(spec, this.part(0.8, MADE));
      const warnings = [
        ...onePerPlace([...open.map((one) => ({ ...one, patches: [] })), ...state.warnings]),
        ...failed.map(notFitted),
        ...stiff.map(notSmoothed),
        ...(finished ? [] : [UNFINISHED]),
      ];
      const fitted = this.spec.keyTimes.slice(1).map((_, i) => !failed.includes(i + 1) && !stiff.includes(i + 1));
      const isMethod = METHOD[this.spec.options.method].curve === 'fitted';
      if (isMethod && fitted.includes(true))
        warnings.push(...(await this.compare(new MotionClient(derived, spec, state))));
      this.shape.checkAlive();
      return [derived, spec, { ...state, warnings }, new UserKeys(this.shape, this.spec, fitted)];
    } catch (error) {
      derived.dispose();
      throw error;
    }
  }

  private part(from: number, to: number): Call {
    return { ...this.call, onProgress: partOf(this.report, from, to) };
  }
}

type Fitted = ResultOf<'fitShells'>;

/** Without those of further shapes in the same interval of keys. */
function onePerPlace(warnings: readonly Warning[]): Warning[] {
  const first = ({ code, key }: Warning): number => warnings.findIndex((one) => one.code === code && one.key === key);
  return warnings.filter((one, i) => first(one) === i);
}

function notFitted(key: number): Warning {
  return {
    ...NO_PLACE,
    code: 'lengths-not-fitted',
    message:
      `Between keys ${key} and ${key + 1}, no shapes were found that keep lengths and angles, ` +
      'so the shape spline (LRI) is shown. Add a key between them.',
    count: 1,
    key,
  };
}

function notSmoothed(key: number): Warning {
  return {
    ...NO_PLACE,
    code: 'bending-not-minimised',
    message:
      `Between keys ${key} and ${key + 1}, the bending energy could not be lowered, because triangles collapse. ` +
      "Shapes there are those of the method 'lengths'. Add a key between them.",
    count: 1,
    key,
  };
}

function bendsMore(share: number): Warning {
  const percent = share < 10 ? `${(100 * share).toFixed(share < 0.1 ? 1 : 0)} %` : `${share.toFixed(0)} times`;
  return {
    ...NO_PLACE,
    code: 'bends-more-than-lri',
    message:
      `By edge lengths and angles, this motion bends ${percent} more than the shape spline (LRI). Add keys, or use the ` +
      "method 'lri'.",
    count: 0,
  };
}

const UNFINISHED: Warning = {
  ...NO_PLACE,
  code: 'bending-search-ended',
  message:
    'The search for the least bending energy ended at its limit of steps. The motion may bend more than the smoothest one.',
  count: 0,
};

function withoutTangents(encoding: EncodingOptions): EncodingOptions {
  return { ...encoding, startTangent: null, endTangent: null };
}
