/** The worker thread of Node. */
import { codecs } from './codecs.ts';
import { serveInNode } from './serve-node.ts';

serveInNode(() => codecs);
