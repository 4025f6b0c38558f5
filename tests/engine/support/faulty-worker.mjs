// The real worker with faults, triggered by the time of a frame: the process ends, an exception is thrown, or wasm
// memory is overwritten so the next call traps. No part of the worker is replaced. A real second thread gets an empty
// stack, so it traps in its first frame. By the number of patches, an elimination order is started and never finished.
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
  // The delay lets the other worker wait for the order.
  201: () => sleep(3000) && process.exit(3),
  202: () => sleep(),
};

// The fault happens first; then the worker receives the message as usual.
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
