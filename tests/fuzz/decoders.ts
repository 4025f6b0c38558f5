/**
 * Fuzz target of the decoders of compressed meshes, which JavaScript calls: `decoders.mjs TARGET SECONDS FOLDER`. Valid
 * files are changed at random, decoded in a thread, and monitored from outside. An input that breaks a promise of
 * `oneInput` is stored in the folder, and the exit code is 1.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { draco, meshopt } from '../engine/support/compress.ts';
import { poseFiles } from '../engine/support/glb.ts';
import { bar } from '../engine/support/shapes.ts';
import { oneInput } from './decoders-input.ts';
import { mutated, randomNumbers } from './mutate.ts';

const SLOW_MS = 30_000;
const COMPRESSORS = { meshopt, draco };

interface Task {
  target: keyof typeof COMPRESSORS;
  seconds: number;
  seed: number;
}

async function fuzz({ target, seconds, seed }: Task): Promise<void> {
  const random = randomNumbers(seed);
  const shapes = [bar(), bar(1, 1), bar(3, 12)].map((mesh) => poseFiles(mesh, [mesh.positions]));
  const seeds = await Promise.all(shapes.map(async (files) => (await COMPRESSORS[target](files))[0]!.bytes));
  const end = performance.now() + 1000 * seconds;
  let tried = 0;
  let decoded = 0;
  while (performance.now() < end) {
    const input = mutated(seeds[Math.floor(random() * seeds.length)]!, random);
    parentPort!.postMessage({ input });
    decoded += Number(await oneInput(input));
    tried += 1;
  }
  parentPort!.postMessage({ done: `${tried} inputs, of which ${decoded} could be decoded` });
}

function watch(task: Task, folder: string): void {
  const worker = new Worker(new URL(import.meta.url), { workerData: task });
  let input = new Uint8Array();
  let timer: NodeJS.Timeout | undefined;
  const fail = (why: string): void => {
    mkdirSync(folder, { recursive: true });
    const place = path.join(folder, `broken-${Date.now()}`);
    writeFileSync(place, input);
    console.error(`${why}\n${place}`);
    process.exit(1);
  };
  worker.on('message', (message: { input?: Uint8Array<ArrayBuffer>; done?: string }) => {
    clearTimeout(timer);
    if (message.done !== undefined) {
      console.error(message.done);
      return;
    }
    input = message.input!;
    timer = setTimeout(() => fail(`decoding takes more than ${SLOW_MS / 1000} s`), SLOW_MS);
  });
  worker.on('error', (error) => fail(error.stack ?? String(error)));
}

if (isMainThread) {
  const [target, seconds, folder] = process.argv.slice(2);
  const seed = Date.now() % 2 ** 31;
  console.error(`seed ${seed}`);
  watch({ target: target as Task['target'], seconds: Number(seconds), seed }, folder!);
} else await fuzz(workerData as Task);
