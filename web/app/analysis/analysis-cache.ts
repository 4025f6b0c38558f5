/** The newest analysis, computed on demand and shared by all callers. */
import type { Analysis, AnalysisInput } from './analysis.ts';
import type { Session } from '../session/session.ts';
import { analyse, analysisInput } from './analysis.ts';

export interface AnalysisObserver {
  /** The motions have changed; `isOther`: they are of another shape than before. */
  onChange(isOther: boolean): void;
  /** What is known is out of date, and nothing is under way that would change that. */
  onStale(): void;
  /** A new analysis of the motions as they still are. */
  onFresh(analysis: Analysis): void;
}

export class AnalysisCache {
  private analysis: Analysis | null = null;
  private outOfDate = true;
  private running: Promise<Analysis | null> | null = null;
  private observer: AnalysisObserver | null = null;
  private of: unknown = null;

  /** `input` gives what to analyse now, null where nothing is open; `shape` what it is of. */
  constructor(
    readonly input: () => AnalysisInput | null,
    readonly onError: (error: unknown) => void,
    private readonly shape: () => unknown,
  ) {}

  get stale(): boolean {
    return this.outOfDate;
  }

  observe(observer: AnalysisObserver): void {
    this.observer = observer;
  }

  /** The motions have changed. */
  invalidate(): void {
    this.outOfDate = true;
    const isOther = this.of !== this.shape();
    this.of = this.shape();
    this.observer?.onChange(isOther);
    if (!this.running) this.observer?.onStale();
  }

  /** Computes unless that is under way; null without a motion or after a failure. */
  refresh(): Promise<Analysis | null> {
    this.running ??= this.compute().finally(() => {
      this.running = null;
      if (this.outOfDate) this.observer?.onStale();
    });
    return this.running;
  }

  /** Of the motions as they are now, computed if it is not there yet; null without a motion or after a failure. */
  async get(): Promise<Analysis | null> {
    if (this.running) await this.running;
    return this.outOfDate || !this.analysis ? this.refresh() : this.analysis;
  }

  private async compute(): Promise<Analysis | null> {
    const input = this.input();
    if (!input || input.sequences.length === 0) return null;
    this.outOfDate = false;
    try {
      const analysis = await analyse(input);
      this.analysis = analysis;
      if (!this.outOfDate) this.observer?.onFresh(analysis);
      return analysis;
    } catch (error) {
      this.onError(error);
      return null;
    }
  }
}

/** Of what is open. `ms`: milliseconds of a frame. The end of a worker has it computed again. */
export function createAnalysisCache(
  { store, workspace, restart, range }: Session,
  ms: () => number,
  onError: (error: unknown) => void,
): AnalysisCache {
  const cache: AnalysisCache = new AnalysisCache(
    () => analysisInput(workspace.sequences, store.get().doc, range(), ms()),
    (error) => (restart.takesUp(error) ? cache.invalidate() : onError(error)),
    () => workspace.info,
  );
  return cache;
}
