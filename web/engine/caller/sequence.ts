/** A shape with one changeable motion. */
import type { MotionChange, Sequence } from '../api/api.ts';
import { isFitted } from '../api/methods.ts';
import { checkRules, checkUpdate, copied, notUpdated } from '../api/options.ts';
import type { Ghost, SequenceStats } from '../api/types.ts';
import type { MotionSpec } from '../wire/protocol.ts';
import { MotionClient } from './motion.ts';
import { urgency } from './scheduler.ts';

export class SequenceClient extends MotionClient implements Sequence {
  protected override readonly what = 'sequence';
  private updates: Promise<unknown> = Promise.resolve();

  async update(change: MotionChange): Promise<void> {
    this.checkAlive();
    if (this.user) throw notUpdated(this.user.spec.options);
    checkRules(checkUpdate(this.spec.options, change).motion, change);
    const given = copied(change); // it may run later
    const work = this.shape.scheduler.run(urgency.shown, async () => {
      const { motion: merged, keyTimes } = checkUpdate(this.spec.options, given);
      const { motion, warnings } = checkRules(merged, given);
      if (isFitted(motion)) throw notUpdated(motion);
      const next = this.shape.spec(motion, keyTimes ?? this.spec.keyTimes);
      const made = await this.shape.make(next);
      this.state = { ...made, warnings: [...warnings, ...made.warnings] };
      this.shape.drop(this.spec);
      this.spec = next;
    });
    this.updates = work.catch(() => undefined);
    return work;
  }

  async stats(): Promise<SequenceStats> {
    return this.shape.stats();
  }

  async patches(): Promise<Int32Array> {
    return this.shape.patches();
  }

  async components(): Promise<Int32Array> {
    return this.shape.components();
  }

  async ghost(): Promise<Ghost | null> {
    return this.shape.ghost();
  }

  override dispose(): void {
    super.dispose();
    this.asked.shape.dispose();
  }

  /** Resolves after all updates requested so far. */
  protected override async settled(): Promise<MotionSpec> {
    await this.updates;
    return super.settled();
  }
}
