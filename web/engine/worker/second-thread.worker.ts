/** The browser's second thread. */
import { help, type HelperStart } from './second-thread.ts';

self.addEventListener('message', ({ data }: MessageEvent<HelperStart>) => help(data, () => self.postMessage(null)), { once: true });
