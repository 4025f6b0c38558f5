/** Node's second thread. */
import { parentPort, workerData } from 'node:worker_threads';
import { help, type SecondThreadStart } from './second-thread.ts';

help(workerData as SecondThreadStart, () => parentPort?.postMessage(null));
