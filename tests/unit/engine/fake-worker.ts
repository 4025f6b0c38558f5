/** A worker whose replies come from the test. */
import { EngineClient, onlyOnce, type Platform } from '../../../web/engine/caller/engine.ts';
import { EngineError } from '../../../web/engine/api/errors.ts';
import type { FromWorker, Program, Request, ToWorker } from '../../../web/engine/wire/protocol.ts';
import type { PortEvents } from '../../../web/engine/caller/worker-client.ts';

export class FakeWorker {
  readonly requests: Request[] = [];
  terminated = false;

  constructor(
    private readonly events: PortEvents,
    private readonly reply: (request: Request) => FromWorker | null,
    private readonly begin: (kind: Program['kind']) => void,
  ) {}

  receive(message: ToWorker): void {
    if (message.type === 'start') return this.begin(message.kind);
    this.requests.push(message);
    const reply = this.reply(message);
    if (reply) queueMicrotask(() => this.say(reply));
  }

  say(message: FromWorker): void {
    if (!this.terminated) this.events.message(message);
  }

  die(): void {
    this.events.failure(new EngineError('crashed', 'it died'));
  }

  of<K extends Request['type']>(type: K): Extract<Request, { type: K }>[] {
    return this.requests.filter((request): request is Extract<Request, { type: K }> => request.type === type);
  }
}

/** Default replies, for requests that a test does not answer: three vertices, one face, keys at 0 and 1. */
export function replyTo(request: Request): FromWorker {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const result = (value: unknown): FromWorker => ({ type: 'result', id: request.id, value: value as never });
  switch (request.type) {
    case 'import':
      return result({
        info: {
          names: ['a', 'b'],
          times: [0, 1],
          faces: Uint32Array.of(0, 1, 2),
          scene: { uvs: null, colors: null, seams: null, polygons: null, groups: [], materials: [], images: [] },
          report: { vertices: 3, faces: 1 },
          warnings: [],
          animations: [],
          animation: -1,
          project: null,
        },
        positions: [positions, positions.slice()],
        normals: null,
      });
    case 'motion':
      return result({ range: [0, 1], warnings: [] });
    case 'evaluate':
      return result({
        ...(request.buffers ?? { positions, normals: positions.slice() }),
        ms: 0,
        threads: 1,
        indefiniteFaces: 0,
      });
    default:
      return result(null);
  }
}

const EMPTY_MODULE = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));

/**
 * An engine over fake workers; `reply` returns null for messages that the test answers. `threaded`: as on a page with
 * shared memory. `fetchFiles`: called before the module for files is available.
 */
export function fakeEngine(
  reply: (request: Request) => FromWorker | null = replyTo,
  threaded: Platform['threaded'] = null,
  fetchFiles: () => Promise<void> = async () => undefined,
): {
  engine: EngineClient;
  /** Workers with the core, and with the module for files. */
  workers: FakeWorker[];
  filesWorkers: FakeWorker[];
} {
  const workers: FakeWorker[] = [];
  const filesWorkers: FakeWorker[] = [];
  const engine = new EngineClient({
    module: Promise.resolve(EMPTY_MODULE),
    shellsModule: async () => EMPTY_MODULE,
    filesModule: onlyOnce(() => fetchFiles().then(() => EMPTY_MODULE)),
    threaded,
    spawn: (events) => {
      const worker = new FakeWorker(events, reply, (kind) => (kind === 'core' ? workers : filesWorkers).push(worker));
      return {
        post: (message) => worker.receive(message),
        terminate: () => {
          worker.terminated = true;
        },
      };
    },
  });
  return { engine, workers, filesWorkers };
}

export const someFile = { name: 'a.glb', bytes: Uint8Array.of(1) };

/** Resolves once all queued tasks have run. */
export const settled = (): Promise<void> => new Promise((wake) => setTimeout(wake, 2));
