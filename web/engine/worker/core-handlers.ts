/** Handlers of a worker with the core: at most one shape, and its motions. */
import { crashed } from '../api/errors.ts';
import type { CoreCallName, FrameData, MotionSpec, RequestOf } from '../wire/protocol.ts';
import { QUERIES, type QueryName } from '../wire/calls.ts';
import { provideOrder } from '../wire/shared-order.ts';
import { Motions } from './motions.ts';
import type { Handlers } from './handlers.ts';
import { ThreadChoice } from './thread-choice.ts';
import type { WasmCore } from './wasm-core.ts';

/** Queries that the core answers alone. */
type DirectQuery = Exclude<QueryName, 'stats'>;

export class CoreHandlers {
  /** The choice of threads, set once a second thread exists. */
  private choice: ThreadChoice | null = null;
  private shape = 0;
  private motions = new Motions();

  constructor(private readonly core: WasmCore) {}

  /** Call when a second thread exists. */
  readonly useSecondThread = (): void => {
    this.choice = new ThreadChoice();
  };

  table(): Handlers<CoreCallName> {
    const { core } = this;
    return {
      ...this.queries(),
      report: (request) => ({ report: core.report(request) }),
      encode: (request, report) => {
        report('welding', 0); // copying and checking large keys takes time
        this.shape = core.encode(request, report);
        this.motions = new Motions();
        return null;
      },
      order: (request) => {
        provideOrder(request.order, () => core.eliminationOrder(request));
        return null;
      },
      motion: ({ motion, order }, report) => this.motions.make(core, this.shape, motion, { order, report }),
      drop: ({ motion }) => {
        this.motions.drop(core, motion);
        return null;
      },
      evaluate: ({ motion, t, buffers }) => this.timed(motion, (handle) => core.evaluate(handle, t, buffers)),
      blend: ({ motion, weights, buffers }) => this.timed(motion, (handle) => core.blend(handle, weights, buffers)),
      stats: () => ({
        ...core.ask('stats', this.shape, {}),
        heapBytes: core.heapBytes,
        threads: this.choice?.chosen ?? 1,
      }),
    };
  }

  /** A frame of the requested motion, with the best number of threads. */
  private timed(motion: MotionSpec, make: (motion: number) => Omit<FrameData, 'ms' | 'threads'>): FrameData {
    const begun = performance.now();
    const { core, choice } = this;
    const handle = this.motions.of(core, this.shape, motion);
    if (choice) core.setThreads(this.shape, choice.threads);
    const start = performance.now();
    try {
      const frame = make(handle);
      choice?.took(performance.now() - start);
      return { ...frame, threads: choice?.chosen ?? 1, ms: performance.now() - begun };
    } catch (reason) {
      // The worker must end, because its second thread may still write to the shared memory.
      throw core.secondThreadLost ? crashed('its second thread failed during a frame') : reason;
    }
  }

  private queries(): Handlers<DirectQuery> {
    const names = Object.keys(QUERIES) as QueryName[];
    // Query and answer belong to the same name, but the compiler cannot follow this through the table.
    return Object.fromEntries(
      names.map((name) => [name, (request: RequestOf<QueryName>) => this.ask(name, request)]),
    ) as unknown as Handlers<DirectQuery>;
  }

  private ask<N extends QueryName>(name: N, request: RequestOf<N>): unknown {
    if (QUERIES[name].of === 'shape') return this.core.ask(name, this.shape, {} as never);
    const { motion, ...asked } = request as { motion: MotionSpec };
    return this.core.ask(name, this.motions.of(this.core, this.shape, motion), asked as never);
  }
}
