/** Serves the playground in another tab: coordinates of the open shape, and the options of its keys. */
import type { Motion } from '../../engine/api/api.ts';
import { MAX_TIME, MOTION, PER_KEY } from '../../engine/api/option-table.ts';
import { validationError } from '../../engine/api/options.ts';
import { setMotion } from '../../model/edits.ts';
import type { KeyPassing, SourceShape, PlaygroundMessage, ShapeCoordinate } from '../../model/playground-channel.ts';
import { messageFrom, playgroundChannel } from '../../model/playground-channel.ts';
import type { Doc } from '../../model/state.ts';
import { referenceKey } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';

export interface PlaygroundParts {
  store: Store;
  workspace: Workspace;
  sequence(): Motion | undefined;
  /** Short title of the open content. */
  title(): string;
  onError(error: unknown): void;
}

/** Number of offered curves of each kind. */
const OFFERED = 12;

export function listenToPlayground({ store, workspace, sequence, title, onError }: PlaygroundParts): void {
  if (!('BroadcastChannel' in window)) return;
  const channel = playgroundChannel();
  const page = `${performance.timeOrigin} ${Math.random()}`;
  const send = (message: PlaygroundMessage): void => channel.postMessage(message);

  const openShape = async (): Promise<SourceShape | null> => {
    const [main, { info, pool }] = [sequence(), workspace];
    const { doc } = store.get();
    if (!main || !info || !pool) return null;
    const { keyCoordinates } = await import('../../study/key-coordinates.ts');
    const measured = keyCoordinates(
      {
        faces: info.faces,
        patches: await main.shape.patches(),
        poses: doc.keys.map((key) => pool.keys.positions(key.pose)),
        reference: referenceKey(doc),
      },
      OFFERED,
    );
    const coordinates = measured.map(({ kind, patches, values }): ShapeCoordinate => {
      const numbers = patches.map((patch) => patch + 1);
      return kind === 'angle'
        ? { name: `Angle between patches ${numbers.join(' and ')}`, unit: '°', values }
        : { name: `Stretch of patch ${numbers[0]}`, unit: '×', values };
    });
    return { page, title: title(), coordinates, ...passingOf(doc) };
  };

  channel.addEventListener('message', ({ data }: MessageEvent<unknown>) => {
    const message = messageFrom(data);
    if (message?.type === 'ask')
      void openShape()
        .then((shape) => shape && send({ type: 'open', shape }))
        .catch(onError);
    if (message?.type !== 'back' || message.page !== page) return;
    if (message.times.length === store.get().doc.keys.length && fits(message)) {
      store.edit('motion from the playground', (doc) => withPassing(doc, message));
      send({ type: 'done', page });
    }
  });
}

function passingOf({ keys, motion }: Doc): KeyPassing {
  const { boundary, startSpeed, endSpeed } = motion;
  return {
    times: keys.map(({ time }) => time),
    boundary,
    startSpeed,
    endSpeed,
    tension: keys.map(({ shaping }) => shaping.tension),
    bias: keys.map(({ shaping }) => shaping.bias),
  };
}

/** Whether the engine accepts these numbers. */
function fits({ times, startSpeed, endSpeed, tension, bias }: KeyPassing): boolean {
  const speeds = validationError(MOTION.startSpeed, startSpeed) ?? validationError(MOTION.endSpeed, endSpeed);
  const wrong = [
    ...tension.map((one) => validationError(PER_KEY.tension, one)),
    ...bias.map((one) => validationError(PER_KEY.bias, one)),
  ];
  return speeds === null && wrong.every((one) => one === null) && times.every((time) => Math.abs(time) <= MAX_TIME);
}

/** Replaces times, ends, tensions and biases; the shapes stay. */
function withPassing(doc: Doc, { times, boundary, startSpeed, endSpeed, tension, bias }: KeyPassing): Doc {
  const keys = doc.keys.map((key, i) => ({
    ...key,
    time: times[i]!,
    shaping: { ...key.shaping, tension: tension[i]!, bias: bias[i]! },
  }));
  return setMotion({ ...doc, keys }, { boundary, startSpeed, endSpeed });
}
