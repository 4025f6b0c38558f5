// Runs tasks on all cores.
import { availableParallelism } from 'node:os';

export const cores = Number(process.env.SHAPESPLINE_JOBS) || availableParallelism();

/**
 * Runs the tasks in order, at most `atOnce` at a time, and returns their results. If some fail, the others finish
 * before the first failure is thrown.
 */
export async function inParallel(tasks, atOnce = cores) {
  const results = [];
  const failures = [];
  const waiting = [...tasks.entries()];
  const worker = async () => {
    while (waiting.length > 0) {
      const [index, task] = waiting.shift();
      try {
        results[index] = await task();
      } catch (error) {
        failures.push(error);
      }
    }
  };
  await Promise.all(Array.from({ length: Math.min(atOnce, tasks.length) }, worker));
  if (failures.length > 0) throw failures[0];
  return results;
}
