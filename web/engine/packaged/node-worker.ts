/** The worker thread of Node in the npm package. */
import { serveInNode } from '../worker/serve-node.ts';
import { codecsFrom } from './codecs-from.ts';

serveInNode((files) => codecsFrom(() => files().codecs));
