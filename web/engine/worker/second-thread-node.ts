/** Node's second thread. */
import { parentPort, workerData } from 'node:worker_threads';
import { help, type HelperStart } from './second-thread.ts';

help(workerData as HelperStart, () => parentPort?.postMessage(null));
