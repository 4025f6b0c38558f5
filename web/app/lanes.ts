/** The running sequences: one lane for each method that is shown. Follows the wanted spec, the newest one wins. */
import type { Engine, Keys, Sequence } from '../engine/api.ts';
import type { EncodingOptions, Method, Progress } from '../engine/types.ts';
import type { Spec } from './spec.ts';
import { motionFor, shapeKey } from './spec.ts';

export interface Lane {
  method: Method;
  sequence: Sequence;
  /** The keys that the sequence was made of. */
  keys: Keys;
}

export interface LanesEvents {
  onProgress(progress: Progress | null): void;
  /** The lanes now serve this spec: draw again. */
  onReady(spec: Spec): void;
  /** The wanted spec was refused; the lanes still serve `current`, if there is one. */
  onRefused(error: unknown, current: Spec | null): void;
}

export class Lanes {
  private lanes: Lane[] = [];
  private served: Spec | null = null;
  private wanted: Spec | null = null;
  private building: { shape: string; abort: AbortController } | null = null;
  private running: Promise<void> | null = null;

  constructor(private readonly engine: Engine, private readonly pool: { readonly keys: Keys }, private readonly events: LanesEvents) {}

  get all(): readonly Lane[] {
    return this.lanes;
  }

  get spec(): Spec | null {
    return this.served;
  }

  /** Resolves when nothing is left to be done. */
  async idle(): Promise<void> {
    while (this.running) await this.running;
  }

  want(spec: Spec): void {
    this.wanted = spec;
    if (this.building && this.building.shape !== buildKey(spec)) this.building.abort.abort();
    this.running ??= this.run();
  }

  /** Goes back to what is served now; only a build can be cancelled. */
  cancel(): void {
    if (!this.building) return;
    this.wanted = this.served;
    this.building.abort.abort();
  }

  dispose(): void {
    this.wanted = null;
    this.building?.abort.abort();
    disposeAll(this.lanes);
    this.lanes = [];
  }

  private async run(): Promise<void> {
    // The caller's store is in the middle of telling everyone about the change that led here.
    await Promise.resolve();
    while (this.wanted && this.wanted !== this.served) {
      const spec = this.wanted;
      try {
        await this.serve(spec);
        this.served = spec;
        this.events.onReady(spec);
      } catch (error) {
        const superseded = this.wanted !== spec;
        if (!superseded) this.wanted = this.served;
        if (!superseded || isFailure(error)) this.events.onRefused(error, this.served);
      }
    }
    this.running = null;
  }

  private async serve(spec: Spec): Promise<void> {
    const reusable = this.served !== null && shapeKey(this.served) === shapeKey(spec);
    const kept = reusable ? this.lanes.slice(0, spec.methods.length) : [];
    const missing = spec.methods.slice(kept.length);
    const added = missing.length > 0 ? await this.build(spec, missing) : [];
    try {
      await Promise.all(kept.map((lane, index) => refit(lane, spec, spec.methods[index]!)));
    } catch (error) {
      disposeAll(added);
      throw error;
    }
    disposeAll(this.lanes.filter((lane) => !kept.includes(lane)));
    this.lanes = [...kept, ...added];
  }

  private async build(spec: Spec, methods: readonly Method[]): Promise<Lane[]> {
    const abort = new AbortController();
    const built: Lane[] = [];
    this.building = { shape: buildKey(spec), abort };
    try {
      for (const [index, method] of methods.entries()) {
        const onProgress = ({ stage, fraction }: Progress): void =>
          this.events.onProgress({ stage, fraction: (index + fraction) / methods.length });
        const keys = this.pool.keys.arrange(spec.order, spec.times, spec.names);
        const options = { ...this.encoding(spec), ...motionFor(spec, method) };
        built.push({ method, keys, sequence: await this.engine.createSequence(keys, options, { signal: abort.signal, onProgress }) });
      }
      return built;
    } catch (error) {
      disposeAll(built);
      throw error;
    } finally {
      this.building = null;
      this.events.onProgress(null);
    }
  }

  private encoding({ encoding, startTangentPose, endTangentPose }: Spec): Partial<EncodingOptions> {
    const pose = (index: number | null): Float32Array | null => (index === null ? null : this.pool.keys.positions(index));
    return { ...encoding, startTangent: pose(startTangentPose), endTangent: pose(endTangentPose) };
  }
}

/** A build is abandoned when what it builds is no longer wanted; other key times or speeds are fitted in afterwards. */
function buildKey(spec: Spec): string {
  return `${shapeKey(spec)}${spec.methods.length}`;
}

async function refit(lane: Lane, spec: Spec, method: Method): Promise<void> {
  await lane.sequence.update({ ...motionFor(spec, method), keyTimes: spec.times });
  lane.method = method;
}

function disposeAll(lanes: readonly Lane[]): void {
  for (const { sequence, keys } of lanes) {
    sequence.dispose();
    keys.dispose();
  }
}

export function isCancelled(error: unknown): boolean {
  return error instanceof Error && 'code' in error && (error.code === 'cancelled' || error.code === 'disposed');
}

function isFailure(error: unknown): boolean {
  return !isCancelled(error);
}
