/** The shown motions, made from as few shapes as possible. Follows the requested plan; the newest counts. */
import type { Engine, Keys, Shape } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import { motionFor } from '../../engine/api/method-options.ts';
import { ENCODING_SHARE, partOf } from '../../engine/api/progress.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { RunningMotion, Variant } from '../../playback/frame-set.ts';
import type { SequencePlan } from './sequence-plan.ts';
import { buildKey, encodingFor, shapeKey } from './sequence-plan.ts';

export interface SequenceSetEvents {
  onProgress(progress: Progress | null): void;
  /** The motions now match this plan and need a redraw. */
  onReady(plan: SequencePlan): void;
  /** The requested plan was refused; the motions still match `current`, if any. */
  onRefused(error: unknown, current: SequencePlan | null): void;
}

interface EncodedShape {
  shape: Shape;
  /** The keys of the shape. */
  keys: Keys;
}

interface Running extends RunningMotion {
  /** The shape's cache key (shapeKey). */
  key: string;
}

/** Encoded shapes by shapeKey. */
type Shapes = ReadonlyMap<string, EncodedShape>;

export class SequenceSet {
  private shapes: Shapes = new Map();
  private motions: readonly Running[] = [];
  private applied: SequencePlan | null = null;
  private wanted: SequencePlan | null = null;
  private building: { key: string; abort: AbortController } | null = null;
  private running: Promise<void> | null = null;

  constructor(
    private readonly engine: Engine,
    private readonly pool: { readonly keys: Keys },
    private readonly events: SequenceSetEvents,
  ) {}

  get all(): readonly RunningMotion[] {
    return this.motions;
  }

  get plan(): SequencePlan | null {
    return this.applied;
  }

  /** Resolves when no work is left. */
  async idle(): Promise<void> {
    while (this.running) await this.running;
  }

  want(plan: SequencePlan): void {
    this.wanted = plan;
    // Changed key times or speeds are applied afterwards.
    if (this.building && this.building.key !== buildKey(plan)) this.building.abort.abort();
    this.running ??= this.run();
  }

  /** Returns to the current motions. Only a build can be cancelled. */
  cancel(): void {
    if (!this.building) return;
    this.wanted = this.applied;
    this.building.abort.abort();
  }

  dispose(): void {
    this.wanted = null;
    this.building?.abort.abort();
    disposeMotions(this.motions, []);
    disposeAll(this.shapes);
    this.shapes = new Map();
    this.motions = [];
  }

  private async run(): Promise<void> {
    // The caller's store is still notifying its subscribers of this change.
    await Promise.resolve();
    while (this.wanted && this.wanted !== this.applied) {
      const plan = this.wanted;
      try {
        if (JSON.stringify(plan) !== JSON.stringify(this.applied)) await this.serve(plan);
        this.applied = plan;
        this.events.onReady(plan);
      } catch (error) {
        const superseded = this.wanted !== plan;
        if (!superseded) this.wanted = this.applied;
        if (!superseded || !isCancelled(error)) this.events.onRefused(error, this.applied);
      }
    }
    this.running = null;
  }

  private async serve(plan: SequencePlan): Promise<void> {
    const variants = new Map(plan.variants.map((variant) => [shapeKey(plan, variant), variant]));
    const kept = [...this.shapes].filter(([key]) => variants.has(key));
    const missing = [...variants].filter(([key]) => !this.shapes.has(key));
    const abort = new AbortController();
    const progress = new BuildProgress(missing.length, this.events.onProgress);
    this.building = { key: buildKey(plan), abort };
    try {
      const added = await this.encode(plan, missing, abort, progress);
      const shapes = new Map([...kept, ...added]);
      const motions = await makeMotions(plan, shapes, this.motions, { signal: abort.signal, progress }).catch(
        (error: unknown) => {
          disposeAll(added);
          throw error;
        },
      );
      disposeMotions(this.motions, motions);
      disposeAll(new Map([...this.shapes].filter(([key]) => !variants.has(key))));
      // New names alone do not encode again.
      for (const { shape } of shapes.values()) shape.rename(plan.names);
      this.shapes = shapes;
      this.motions = motions;
    } finally {
      this.building = null;
      progress.end();
    }
  }

  private async encode(
    plan: SequencePlan,
    missing: [key: string, variant: Variant][],
    abort: AbortController,
    progress: BuildProgress,
  ): Promise<Shapes> {
    const encodeOne = async ([key, variant]: [string, Variant]): Promise<[string, EncodedShape]> => {
      const keys = this.pool.keys.arrange(plan.order, plan.times, plan.names);
      const call = { signal: abort.signal, onProgress: progress.of(key, 0, ENCODING_SHARE) };
      return [key, { keys, shape: await this.engine.encode(keys, encodingFor(plan, variant, this.pool.keys), call) }];
    };
    // Each shape has a separate worker.
    const encodings = missing.map(encodeOne);
    try {
      return new Map(await Promise.all(encodings));
    } catch (error) {
      // A plan needs all of its shapes.
      abort.abort();
      for (const one of await Promise.allSettled(encodings))
        if (one.status === 'fulfilled') disposeAll(new Map([one.value]));
      throw error;
    }
  }
}

/** Total progress of all shapes that are made at the same time. */
class BuildProgress {
  private readonly fractions = new Map<string, number>();

  constructor(
    private readonly shapes: number,
    private readonly tell: SequenceSetEvents['onProgress'],
  ) {}

  /** The progress callback for one part of a shape's work. */
  of(shape: string, from: number, to: number): (progress: Progress) => void {
    return partOf(
      ({ stage, fraction }) => {
        this.fractions.set(shape, fraction);
        const done = [...this.fractions.values()].reduce((sum, share) => sum + share, 0);
        this.tell({ stage, fraction: done / Math.max(this.shapes, this.fractions.size) });
      },
      from,
      to,
    );
  }

  end(): void {
    if (this.fractions.size > 0) this.tell(null);
  }
}

/** One motion per variant, reusing existing ones. Makes all of them or none. */
async function makeMotions(
  plan: SequencePlan,
  shapes: Shapes,
  present: readonly Running[],
  { signal, progress }: { signal: AbortSignal; progress: BuildProgress },
): Promise<Running[]> {
  const made = await Promise.allSettled(
    plan.variants.map(async (variant) => {
      const of = shapeKey(plan, variant);
      const options = { ...motionFor(plan.motion, variant), keyTimes: plan.times };
      const key = JSON.stringify([of, options]);
      const there = present.find((motion) => motion.key === key);
      if (there) return { ...variant, key, sequence: there.sequence };
      const call = { signal, onProgress: progress.of(of, ENCODING_SHARE, 1) };
      return { ...variant, key, sequence: await shapes.get(of)!.shape.motion(options, call) };
    }),
  );
  const motions = made.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : []));
  const failure = made.find((one) => one.status === 'rejected');
  if (!failure) return motions;
  disposeMotions(motions, present);
  throw failure.reason;
}

/** Disposes of the motions that are not kept. */
function disposeMotions(motions: readonly Running[], kept: readonly Running[]): void {
  for (const { sequence } of motions) if (!kept.some((other) => other.sequence === sequence)) sequence.dispose();
}

function disposeAll(shapes: Shapes): void {
  for (const { shape, keys } of shapes.values()) {
    shape.dispose();
    keys.dispose();
  }
}
