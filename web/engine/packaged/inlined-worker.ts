/** The text of `worker.js`: the one-file build has it here. */
export const inlinedWorker: string | null = null;
