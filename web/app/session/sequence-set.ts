/** The running sequences: one per motion that is shown. Follows the wanted plan, the newest one wins. */
import type { Engine, Keys } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { RunningMotion, Variant } from '../../playback/frame-set.ts';
import type { SequencePlan } from './sequence-plan.ts';
import { motionFor, optionsFor, variantKey } from './sequence-plan.ts';

export interface RunningSequence extends RunningMotion {
  /** What the sequence was built for (variantKey). */
  key: string;
  /** The keys that the sequence was made of. */
  keys: Keys;
}

export interface SequenceSetEvents {
  onProgress(progress: Progress | null): void;
  /** The sequences now serve this plan: draw again. */
  onReady(plan: SequencePlan): void;
  /** The wanted plan was refused; the sequences still serve `current`, if there is one. */
  onRefused(error: unknown, current: SequencePlan | null): void;
}

export class SequenceSet {
  private sequences: RunningSequence[] = [];
  private served: SequencePlan | null = null;
  private wanted: SequencePlan | null = null;
  private building: { shape: string; abort: AbortController } | null = null;
  private running: Promise<void> | null = null;

  constructor(
    private readonly engine: Engine,
    private readonly pool: { readonly keys: Keys },
    private readonly events: SequenceSetEvents,
  ) {}

  get all(): readonly RunningSequence[] {
    return this.sequences;
  }

  get plan(): SequencePlan | null {
    return this.served;
  }

  /** Resolves when nothing is left to be done. */
  async idle(): Promise<void> {
    while (this.running) await this.running;
  }

  want(plan: SequencePlan): void {
    this.wanted = plan;
    if (this.building && this.building.shape !== buildKey(plan)) this.building.abort.abort();
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
    disposeAll(this.sequences);
    this.sequences = [];
  }

  private async run(): Promise<void> {
    // The caller's store is in the middle of telling everyone about the change that led here.
    await Promise.resolve();
    while (this.wanted && this.wanted !== this.served) {
      const plan = this.wanted;
      try {
        if (JSON.stringify(plan) !== JSON.stringify(this.served)) await this.serve(plan);
        this.served = plan;
        this.events.onReady(plan);
      } catch (error) {
        const superseded = this.wanted !== plan;
        if (!superseded) this.wanted = this.served;
        if (!superseded || !isCancelled(error)) this.events.onRefused(error, this.served);
      }
    }
    this.running = null;
  }

  private async serve(plan: SequencePlan): Promise<void> {
    const spare = [...this.sequences];
    const kept = plan.variants.map((variant) =>
      takeWhere(spare, (running) => running.key === variantKey(plan, variant)),
    );
    const missing = plan.variants.filter((_, index) => !kept[index]);
    const added = missing.length > 0 ? await this.build(plan, missing) : [];
    try {
      await Promise.all(kept.map((running, index) => running && refit(running, plan, plan.variants[index]!)));
    } catch (error) {
      disposeAll(added);
      throw error;
    }
    disposeAll(spare);
    this.sequences = kept.map((running) => running ?? added.shift()!);
  }

  private async build(plan: SequencePlan, variants: readonly Variant[]): Promise<RunningSequence[]> {
    const abort = new AbortController();
    const fractions = variants.map(() => 0);
    const progressOf =
      (index: number) =>
      ({ stage, fraction }: Progress): void => {
        fractions[index] = fraction;
        const done = fractions.reduce((sum, share) => sum + share, 0);
        this.events.onProgress({ stage, fraction: done / variants.length });
      };
    const buildOne = async (variant: Variant, index: number): Promise<RunningSequence> => {
      const keys = this.pool.keys.arrange(plan.order, plan.times, plan.names);
      const options = optionsFor(plan, variant, this.pool.keys);
      const call = { signal: abort.signal, onProgress: progressOf(index) };
      return {
        ...variant,
        key: variantKey(plan, variant),
        keys,
        sequence: await this.engine.createSequence(keys, options, call),
      };
    };
    this.building = { shape: buildKey(plan), abort };
    const builds = variants.map(buildOne);
    try {
      // Each in a worker of its own.
      return await Promise.all(builds);
    } catch (error) {
      // One without the others is of no use.
      abort.abort();
      for (const build of await Promise.allSettled(builds)) if (build.status === 'fulfilled') disposeAll([build.value]);
      throw error;
    } finally {
      this.building = null;
      this.events.onProgress(null);
    }
  }
}

/** A build is abandoned when what it builds is no longer wanted; other key times or speeds are fitted in afterwards. */
function buildKey(plan: SequencePlan): string {
  return plan.variants.map((variant) => variantKey(plan, variant)).join();
}

/** Takes the first that fits out of the list. */
function takeWhere<T>(list: T[], fits: (item: T) => boolean): T | undefined {
  const index = list.findIndex(fits);
  return index < 0 ? undefined : list.splice(index, 1)[0];
}

async function refit(running: RunningSequence, plan: SequencePlan, variant: Variant): Promise<void> {
  await running.sequence.update({ ...motionFor(plan, variant), keyTimes: plan.times });
  running.method = variant.method;
  if (variant.plain) running.plain = true;
  else delete running.plain;
}

function disposeAll(sequences: readonly RunningSequence[]): void {
  for (const { sequence, keys } of sequences) {
    sequence.dispose();
    keys.dispose();
  }
}
