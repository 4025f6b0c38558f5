/** The browser's second thread. */
import { help, type HelperStart } from './helper.ts';

self.addEventListener('message', ({ data }: MessageEvent<HelperStart>) => help(data, () => self.postMessage(null)), { once: true });
