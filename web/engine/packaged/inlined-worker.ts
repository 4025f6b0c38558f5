/** The text of `worker.js`. Only the one-file build sets it. */
export const inlinedWorker: string | null = null;
