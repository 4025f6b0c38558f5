/** A worker's inside: one core, at most one shape, requests answered in the order in which they came. */
import { WasmCore, type OnProgress } from './wasm-core.ts';
import {
  crashed,
  EngineError,
  engineError,
  isOutOfMemory,
  messageOf,
  outOfMemory,
  type ErrorData,
} from '../api/errors.ts';
import type { SecondThreadStart } from './second-thread.ts';
import type { Codecs } from './codecs.ts';
import { compress } from './compress.ts';
import { Motions } from './motions.ts';
import { importFiles, type Decode } from './import-files.ts';
import type {
  CallName,
  FrameBuffers,
  FrameData,
  FromWorker,
  MotionSpec,
  Request,
  RequestOf,
  ResultOf,
  Start,
  ToWorker,
} from '../wire/protocol.ts';
import { QUESTIONS, type QuestionName } from '../wire/calls.ts';
import { provideOrder } from '../wire/shared-order.ts';
import { ThreadChoice } from './thread-choice.ts';
import type { CreateWasmModule } from './wasm-module.ts';

export interface HandlerHost {
  post(message: FromWorker, transfer: ArrayBuffer[]): void;
  create: CreateWasmModule;
  /** The glue of the threaded module. */
  createThreaded(): Promise<CreateWasmModule>;
  /** Starts a second thread; one that never gets ready is never waited for. */
  startSecondThread(start: SecondThreadStart, onReady: () => void): void;
  /** Undoes mesh compression that the core does not know, before it sees the files. */
  decode: Decode;
  /** For exports that are compressed. */
  codecs: Codecs;
}

/** Questions that the core answers by itself. */
type Asked = Exclude<QuestionName, 'stats'>;

type Handlers = {
  [K in Exclude<CallName, Asked>]: (
    core: WasmCore,
    request: RequestOf<K>,
    report: OnProgress,
  ) => ResultOf<K> | Promise<ResultOf<K>>;
};

export class RequestHandler {
  private readonly host: HandlerHost;
  private readonly handlers: Handlers;
  private core: Promise<WasmCore> | null = null;
  /** Once there is a second thread. */
  private choice: ThreadChoice | null = null;
  private tail: Promise<void> = Promise.resolve();
  private shape = 0;
  private motions = new Motions();
  private readonly frames: FrameBuffers[] = [];

  constructor(host: HandlerHost) {
    this.host = host;
    this.handlers = this.makeHandlers();
  }

  receive(message: ToWorker): void {
    if (message.type === 'start') {
      this.core = this.start(message).catch((reason: unknown) => {
        throw reason instanceof WebAssembly.LinkError ? mismatch(reason) : reason;
      });
      this.core.catch(() => undefined); // said by the first request
      return;
    }
    this.tail = this.tail.then(() => this.serve(message));
  }

  private async start({ module, threaded }: Start): Promise<WasmCore> {
    const core = threaded && (await this.startThreaded(threaded).catch(() => null));
    return core ?? WasmCore.start(this.host.create, module);
  }

  private async startThreaded(compiled: WebAssembly.Module): Promise<WasmCore> {
    const core = await WasmCore.start(await this.host.createThreaded(), compiled);
    const start = core.secondThreadStart(compiled);
    if (start)
      this.host.startSecondThread(start, () => {
        this.choice = new ThreadChoice();
      });
    return core;
  }

  private async serve(request: Request): Promise<void> {
    const { id } = request;
    const report: OnProgress = (stage, fraction) => this.host.post({ type: 'progress', id, stage, fraction }, []);
    try {
      const core = await this.core;
      if (!core) throw crashed('the worker was not started');
      const value = await this.answer(core, request, report);
      this.host.post({ type: 'result', id, value }, buffersOf(value));
    } catch (reason) {
      const { error, fatal } = describe(reason);
      this.host.post({ type: 'error', id, error, fatal }, []);
    }
  }

  private answer(
    core: WasmCore,
    request: Request,
    report: OnProgress,
  ): ResultOf<CallName> | Promise<ResultOf<CallName>> {
    // Request and handler belong to the same name, which the compiler cannot follow through the table.
    const handler = (this.handlers as Record<string, unknown>)[request.type] as
      | ((core: WasmCore, request: Request, report: OnProgress) => ResultOf<CallName>)
      | undefined;
    return handler ? handler(core, request, report) : (this.ask(core, request as never) as ResultOf<CallName>);
  }

  private makeHandlers(): Handlers {
    return {
      import: (core, { files, options }, report) => importFiles(core, this.host.decode, { files, options, report }),
      encode: (core, request, report) => {
        report('welding', 0); // large keys take a moment to be copied and checked
        this.shape = core.encode(request, report);
        this.motions = new Motions();
        return null;
      },
      order: (core, request) => {
        provideOrder(request.order, () => core.eliminationOrder(request));
        return null;
      },
      motion: (core, { motion, order }, report) => this.motions.make(core, this.shape, motion, { order, report }),
      drop: (core, { motion }) => {
        this.motions.drop(core, motion);
        return null;
      },
      evaluate: (core, { motion, t, buffers }) =>
        this.timed(core, motion, (handle) => core.evaluate(handle, t, buffers)),
      blend: (core, { motion, weights, buffers }) =>
        this.timed(core, motion, (handle) => core.blend(handle, weights, buffers)),
      stats: (core) => ({
        ...core.ask('stats', this.shape, {}),
        heapBytes: core.heapBytes,
        threads: this.choice?.chosen ?? 1,
      }),
      glbSize: (core, request) => core.animationSize(request),
      addFrame: (_, { positions, normals }) => {
        this.frames.push({ positions, normals });
        return null;
      },
      principalOffsets: (core, request) => core.principalOffsets(request),
      writeAnimation: async (core, request) => {
        const bytes = core.writeAnimation(this.frames.splice(0), request);
        const { compression } = request;
        return compression === 'none' ? bytes : compress(this.host.codecs, bytes, compression);
      },
      writePose: (core, request) => core.writePose(request),
    };
  }

  /** A frame of the motion that is meant, made by as many threads as are best. */
  private timed(
    core: WasmCore,
    motion: MotionSpec,
    make: (motion: number) => Omit<FrameData, 'ms' | 'threads'>,
  ): FrameData {
    const begun = performance.now();
    const handle = this.motions.of(core, this.shape, motion);
    const { choice } = this;
    if (choice) core.setThreads(this.shape, choice.threads);
    const start = performance.now();
    try {
      const frame = make(handle);
      choice?.took(performance.now() - start);
      return { ...frame, threads: choice?.chosen ?? 1, ms: performance.now() - begun };
    } catch (reason) {
      // It takes this worker with it: nobody could say what it still writes.
      throw core.secondThreadLost ? crashed('its second thread broke down in the middle of a frame') : reason;
    }
  }

  private ask(core: WasmCore, request: Request & { type: QuestionName }): unknown {
    const { type, id: _, ...asked } = request;
    if (QUESTIONS[type].of === 'shape') return core.ask(type, this.shape, asked as never);
    const { motion, ...rest } = asked as { motion: MotionSpec };
    return core.ask(type, this.motions.of(core, this.shape, motion), rest as never);
  }
}

// What the core says of itself leaves it sound, but for memory that ran out in the middle and its own defects. Anything
// else that arrives here is a trap.
function describe(reason: unknown): { error: ErrorData; fatal: boolean } {
  const error = reason instanceof EngineError ? reason : trapped(messageOf(reason));
  const fatal = error !== reason || ['out-of-memory', 'internal', 'crashed', 'not-loaded'].includes(error.code);
  return { error: { code: error.code, message: error.message, place: error.place }, fatal };
}

// Files of two releases, say from a cache that holds an old one.
function mismatch(reason: Error): EngineError {
  return engineError(
    'not-loaded',
    'The loaded parts of the program are of different versions. Reload the page without its ' +
      `cache, or rebuild it (${reason.message}).`,
  );
}

function trapped(text: string): EngineError {
  return isOutOfMemory(text) ? outOfMemory() : crashed(text);
}

/** The buffers of all typed arrays in a result, to be transferred. */
export function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) {
    if (value.buffer instanceof ArrayBuffer) found.add(value.buffer);
  } else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) buffersOf(part, found);
  }
  return [...found];
}
