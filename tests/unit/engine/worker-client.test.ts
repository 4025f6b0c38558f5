/** The caller's side of a worker whose port refuses some messages. */
import { expect, it } from 'vitest';
import { WorkerClient, type FilesWorker, type PortEvents } from '../../../web/engine/caller/worker-client.ts';
import type { Program, ToWorker } from '../../../web/engine/wire/protocol.ts';

const program = { kind: 'files', module: {}, threaded: null, files: {} } as Program;

/** A client whose port clones messages as a worker does, and the messages that arrived. */
function setUp(start: Program): { client: FilesWorker; got: ToWorker[]; ended: () => boolean } {
  const got: ToWorker[] = [];
  let ended = false;
  const spawn = (_: PortEvents) => ({
    post: (message: ToWorker) => void got.push(structuredClone(message)),
    terminate: () => {
      ended = true;
    },
  });
  return { client: new WorkerClient(spawn, Promise.resolve(start)), got, ended: () => ended };
}

const outcome = (work: Promise<unknown>): Promise<string> =>
  work.then(
    () => 'done',
    ({ code }: { code: string }) => code,
  );

it('a message that cannot be posted rejects its call, and the worker goes on', async () => {
  const { client, got, ended } = setUp(program);
  const call = (data: unknown): Promise<string> => outcome(client.call('import', { files: data } as never));
  const [refused] = [call(() => 0), call('good')];
  expect(await refused).toBe('invalid-option');
  expect([got.map(({ type }) => type), ended(), client.alive]).toEqual([['start', 'import'], false, true]);
});

it('a program that cannot be posted ends the worker', async () => {
  const { client, ended } = setUp({ ...program, module: (() => 0) as never });
  expect(await outcome(client.call('import', {} as never))).toBe('crashed');
  expect(ended()).toBe(true);
});
