/** The newest analysis, computed on demand and shared by all callers. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Analysis, AnalysisInput } from './analysis.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { Session } from '../session/session.ts';
import { analyse, analysisInput } from './analysis.ts';

export interface AnalysisObserver {
  /** The motions have changed. `isOther`: they belong to another shape. */
  onChange(isOther: boolean): void;
  /** The analysis is out of date, and no new one is being computed. */
  onStale(): void;
  /** The computed share of an analysis, in [0, 1]; null when it has ended. */
  onWorking(fraction: number | null): void;
  /** A new analysis of the current motions. */
  onFresh(analysis: Analysis): void;
}

export class AnalysisCache {
  private analysis: Analysis | null = null;
  private outOfDate = true;
  private running: Promise<Analysis | null> | null = null;
  private observer: AnalysisObserver | null = null;
  private of: unknown = null;
  private abort = new AbortController();

  /** `input` returns the motions to analyse, or null if nothing is open; `shape` returns their shape. */
  constructor(
    readonly input: () => AnalysisInput | null,
    readonly onError: (error: unknown) => void,
    private readonly shape: () => unknown,
  ) {}

  get stale(): boolean {
    return this.outOfDate;
  }

  /** Tells `observer` the present state at once. */
  observe(observer: AnalysisObserver): void {
    this.observer = observer;
    if (this.analysis && !this.outOfDate) observer.onFresh(this.analysis);
    else observer.onChange(false);
  }

  invalidate(): void {
    this.outOfDate = true;
    this.abort.abort();
    const isOther = this.of !== this.shape();
    this.of = this.shape();
    this.observer?.onChange(isOther);
    if (!this.running) this.observer?.onStale();
  }

  /** Computes an analysis unless one is in progress; null without a motion or after a failure. */
  refresh(): Promise<Analysis | null> {
    this.running ??= this.compute().finally(() => {
      this.running = null;
      if (this.outOfDate) this.observer?.onStale();
    });
    return this.running;
  }

  /** The analysis of the current motions, computed if missing; null without a motion or after a failure. */
  async get(): Promise<Analysis | null> {
    if (this.running) await this.running;
    return this.outOfDate || !this.analysis ? this.refresh() : this.analysis;
  }

  private async compute(): Promise<Analysis | null> {
    const input = this.input();
    if (!input || input.sequences.length === 0) return null;
    this.outOfDate = false;
    this.of = this.shape();
    this.abort = new AbortController();
    const { signal } = this.abort;
    this.observer?.onWorking(0);
    try {
      const onProgress = ({ fraction }: Progress): void => this.observer?.onWorking(fraction);
      const analysis = await analyse(input, { signal, onProgress });
      this.analysis = analysis;
      if (!this.outOfDate) this.observer?.onFresh(analysis);
      return analysis;
    } catch (error) {
      if (!signal.aborted || !isCancelled(error)) this.onError(error);
      return null;
    } finally {
      this.observer?.onWorking(null);
    }
  }
}

/** Caches the analysis of the open shape. `ms`: milliseconds per frame. Recomputes when a worker ends. */
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
