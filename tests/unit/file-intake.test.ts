/** Interpretation of picked files, without a page. */
import { beforeEach, expect, it, vi } from 'vitest';
import { createStore } from '../../web/app/session/store.ts';
import type { Opener } from '../../web/app/sources/opener.ts';
import { FileIntake } from '../../web/app/sources/file-intake.ts';
import { EngineError, vertexCountMismatch } from '../../web/engine/api/errors.ts';
import type { InsertPosition } from '../../web/model/edits.ts';
import type { Source } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import type { Offer } from '../../web/ui/messages.ts';
import type { PickedFile } from '../../web/ui/dropped-files.ts';

const log: string[] = [];
let offer: Offer | null = null;
beforeEach(() => {
  log.length = 0;
  offer = null;
});

const picked = (...names: string[]): PickedFile[] => names.map((name) => ({ name, file: new File([], name) }));
const names = (files: readonly PickedFile[]): string => files.map(({ name }) => name).join('+');
const own: Source = { kind: 'files', names: ['mine.obj'] };
const sample: Source = { kind: 'sample', id: 'box' };

/**
 * `fit`: whether the files match the open mesh, or the names of those that do. A single file does not open as a motion,
 * and neither do files of which only some fit.
 */
function fileIntakeOf(source: Source, fit: boolean | string[]): FileIntake {
  const fits = ({ name }: PickedFile): boolean => (Array.isArray(fit) ? fit.includes(name) : fit);
  const files = {
    run: async (given: PickedFile[], work: (files: PickedFile[]) => Promise<boolean>) => work(await given),
    async open(given: PickedFile[]) {
      log.push(`open ${names(given)}`);
      if (given.length < 2) throw new EngineError('too-few-keys', 'One key.');
      if (given.some(fits) !== given.every(fits)) throw vertexCountMismatch('right.obj', 4, 3);
      return true;
    },
    async addPoses(given: PickedFile[], place: InsertPosition | null) {
      log.push(`add ${names(given)} at ${JSON.stringify(place)}`);
      if (!given.every(fits)) throw vertexCountMismatch('a.obj', 3, 4);
      return given.length;
    },
  };
  return new FileIntake({
    store: createStore({ ...EMPTY_STATE, source }),
    files: files as unknown as Opener,
    say: (text) => log.push(text),
    onOffer: (next) => (offer = next),
    onPick: () => log.push('pick'),
  });
}
const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

it('several new files of the open mesh become keys', async () => {
  await fileIntakeOf(own, true).take(picked('a.obj', 'b.obj'));
  expect(log).toEqual(['add a.obj+b.obj at null', '2 keys were added.']);
});

it('files of another mesh are opened, and the difference is reported with counts', async () => {
  await fileIntakeOf(own, false).take(picked('a.obj', 'b.obj'), { before: 1 });
  expect(log).toEqual([
    'add a.obj+b.obj at {"before":1}',
    'a.obj has 3 vertices, but the keys have 4. The files are opened as another motion.',
    'open a.obj+b.obj',
  ]);
  expect(offer).toBeNull();
});

it('one pose of another mesh waits for the next, and replaces nothing', async () => {
  const fileIntake = fileIntakeOf(own, false);
  await fileIntake.take(picked('a.obj'), { time: 0.5 });
  expect(log).toEqual(['add a.obj at {"time":0.5}', 'open a.obj']);
  expect(offer?.message).toBe(
    'a.obj has 3 vertices, but the keys have 4. “a.obj” is the first pose of another motion. Drop or choose the next pose.',
  );
  await fileIntake.take(picked('b.obj'));
  expect(log.at(-1)).toBe('open a.obj+b.obj');
});

it('the first pose waits for the next', async () => {
  const fileIntake = fileIntakeOf(sample, false);
  await fileIntake.take(picked('a.obj'));
  expect(offer?.message).toContain('“a.obj” is the first pose of a motion.');
  await fileIntake.take(picked('b.obj'));
  expect(log).toEqual(['open a.obj', 'add a.obj at null', 'open a.obj+b.obj']);
  expect(offer).toBeNull();
  await fileIntake.take(picked('c.obj', 'd.obj'));
  expect(log.at(-1)).toBe('open c.obj+d.obj');
});

it('the user chooses one of several numbered sequences', async () => {
  await fileIntakeOf(sample, false).take(picked('a1.obj', 'a2.obj', 'b1.obj', 'b2.obj'));
  expect(log).toEqual([]);
  expect(offer?.others?.at(-1)?.action).toBe('All of them');
  offer?.onAccept?.();
  await settled();
  expect(log).toEqual(['open a1.obj+a2.obj']);
});

it('a pose that fits the open mesh is added, also after one that does not', async () => {
  for (const [source, place] of [
    [own, null],
    [own, { time: 0.5 }],
    [sample, null],
  ] as const) {
    const fileIntake = fileIntakeOf(source, ['right.obj', 'more.obj']);
    await fileIntake.take(picked('wrong.obj'));
    expect(fileIntake.waits).toBe(true);
    log.length = 0;
    await fileIntake.take(picked('right.obj'), place);
    expect(log.slice(-2)).toEqual([`add right.obj at ${JSON.stringify(place)}`, '“right.obj” was added as a key.']);
    expect([offer, fileIntake.waits]).toEqual([null, false]);
  }
  const fileIntake = fileIntakeOf(own, ['right.obj', 'more.obj']);
  await fileIntake.take(picked('wrong.obj'));
  await fileIntake.take(picked('right.obj', 'more.obj'));
  expect(log.at(-1)).toBe('2 keys were added.');
});

it('a pose that fits neither the open mesh nor the waiting pose is refused, and names both', async () => {
  const fileIntake = fileIntakeOf(own, ['waits.obj', 'next.obj']);
  const add = vi.spyOn(fileIntake as never, 'add');
  add.mockResolvedValue(vertexCountMismatch('neither.obj', 3, 4) as never);
  await fileIntake.take(picked('waits.obj'));
  await expect(fileIntake.take(picked('neither.obj'))).rejects.toThrow(
    'neither.obj has 3 vertices, but the keys have 4. It does not fit “waits.obj” either, which waits for its next pose.',
  );
  await fileIntake.take(picked('next.obj'));
  expect(log.at(-1)).toBe('open waits.obj+next.obj');
});

it('a waiting pose can be dropped', async () => {
  const fileIntake = fileIntakeOf(own, false);
  await fileIntake.take(picked('wrong.obj'));
  fileIntake.forget();
  expect([offer, fileIntake.waits]).toEqual([null, false]);
  await fileIntake.take(picked('a.obj'));
  expect(log).not.toContain('open wrong.obj+a.obj');
});
