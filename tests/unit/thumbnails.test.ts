import { expect, it } from 'vitest';
import { createThumbnails } from '../../web/app/drawing/thumbnails.ts';
import type { ThumbnailParts } from '../../web/app/drawing/thumbnails.ts';

it('what is opened while pictures of something else are being made has its own', async () => {
  const made: string[] = [];
  let free = (): void => undefined;
  let busy = new Promise<void>((resolve) => {
    free = resolve;
  });
  const open = (name: string): object => ({
    pool: { name },
    sequences: [
      {
        sequence: {
          keyTimes: [0, 1],
          evaluateMany: (times: number[]) => Promise.resolve([{ name, t: times[0], release: () => undefined }]),
        },
      },
    ],
  });
  const workspace = open('before');
  const thumbnails = createThumbnails({
    store: { get: () => ({ doc: { keys: [0, 1].map((time) => ({ pose: time, time })) } }) },
    workspace,
    scene: {
      viewer: { textured: () => Promise.resolve() },
      thumbnail: ({ name, t }: { name: string; t: number }) => `${name} ${t}`,
    },
    idle: () => busy,
    has: (pose: number) => made.includes(`after ${pose}`),
    onThumbnail: (_: number, url: string) => made.push(url),
  } as unknown as ThumbnailParts);

  thumbnails.refresh();
  await new Promise((resolve) => setTimeout(resolve));
  Object.assign(workspace, open('after'));
  thumbnails.refresh();
  free();
  busy = Promise.resolve();
  await expect.poll(() => made).toEqual(['after 0', 'after 1']);
});
