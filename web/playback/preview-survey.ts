/** Finds out in moments of rest what previews cost and where they are close, before they are needed. */
import type { Demand } from './demand.ts';
import { gather } from './frame-set.ts';

/** Rest after which it begins. */
const DELAY_MS = 300;
/** The first preview makes what all of them need; the second one is measured. */
const TRIES = 2;

export class PreviewSurvey {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private measuring = false;

  /** `isIdle` tells whether nothing else is asked for. */
  constructor(
    private readonly demand: Demand,
    private readonly isIdle: () => boolean,
  ) {}

  /** Nothing is asked for now. */
  schedule(): void {
    this.timer = setTimeout(() => void this.run(this.demand.wanted.t), DELAY_MS);
  }

  cancel(): void {
    clearTimeout(this.timer);
  }

  /** Measures where previews are close, nearest to t first and as long as `wanted`. */
  async measure(t: number, wanted: () => boolean): Promise<void> {
    if (this.measuring) return;
    this.measuring = true;
    const { policy, sequences: now } = this.demand;
    const sequences = now();
    while (wanted() && sequences === now()) {
      const sample = policy.unmeasured(sequences, t);
      // A failure is left to whoever asks for a frame.
      const errors =
        sample &&
        (await Promise.all(sequences.map(({ sequence }) => sequence.previewError(sample.t))).catch(() => null));
      if (!sample || !errors) break;
      policy.noteErrors(sequences, sample, errors);
    }
    this.measuring = false;
  }

  private async run(t: number): Promise<void> {
    if (this.demand.policy.untried(this.demand.sequences())) await this.tryPreviews(t);
    await this.measure(t, this.isIdle);
  }

  private async tryPreviews(t: number): Promise<void> {
    const { policy, sequences: now } = this.demand;
    const sequences = now();
    for (let tries = 0; tries < TRIES && this.isIdle() && sequences === now(); tries += 1) {
      // A failure is left to whoever asks for a frame.
      const frames = await gather(sequences, t, { preview: true, blend: null }, (sequence) =>
        sequence.evaluateAhead(t, { preview: true }),
      ).catch(() => null);
      if (!frames) return;
      policy.noteCost(frames);
      frames.release();
    }
  }
}
