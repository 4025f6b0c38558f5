/** The browser's second thread. */
import { help, type SecondThreadStart } from './second-thread.ts';

self.addEventListener(
  'message',
  ({ data }: MessageEvent<SecondThreadStart>) => help(data, () => self.postMessage(null)),
  { once: true },
);
