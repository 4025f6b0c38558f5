// The real worker, with faults that a test calls for by the time of a frame. Nothing of the worker itself is replaced:
// the process ends, an exception is thrown, or the wasm memory is overwritten so that the next call traps. A second
// thread is the real one, too, with a stack that ends where it begins: it traps in the middle of the first frame that
// it helps with. An order of elimination is begun and never found, by the number of patches.
import { syncBuiltinESMExports } from 'node:module';
import threads, { parentPort, Worker } from 'node:worker_threads';

threads.Worker = class extends Worker {
  constructor(url, options) {
    super(url, { ...options, workerData: { ...options.workerData, stack: 0 } });
  }
};
syncBuiltinESMExports();

const memories = [];
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...args) => {
  const instance = await instantiate(...args);
  memories.push(...Object.values(instance.exports).filter((part) => part instanceof WebAssembly.Memory));
  return instance;
};

const faults = {
  1001: () => process.exit(3),
  1002: () => {
    throw new Error('something broke');
  },
  1003: () => memories.forEach((memory) => new Uint8Array(memory.buffer).fill(0xff)),
  1004: () => {
    throw new RangeError('Array buffer allocation failed');
  },
};

const sleep = (ms) => Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, ms);
const orderFaults = {
  // Long enough for the other worker to wait for it.
  201: () => sleep(3000) && process.exit(3),
  202: () => sleep(),
};

// The fault comes first, then the worker receives the message as usual.
const on = parentPort.on.bind(parentPort);
parentPort.on = (name, listener) => on(name, (message) => {
  if (message.type === 'evaluate') faults[message.t]?.();
  const orderFault = message.type === 'order' && orderFaults[message.encoding.patches];
  if (orderFault) {
    Atomics.store(message.order, 0, 1);
    orderFault();
  }
  listener(message);
});

await import('../../../build/node/node-worker.mjs');
