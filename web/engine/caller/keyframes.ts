/** Keys on the caller's side: arrays of their own, tied to no worker. */
import type { Keys } from '../api/api.ts';
import { disposed, EngineError, invalidOption } from '../api/errors.ts';
import { checkTimes } from '../api/options.ts';
import type { ImportedData, KeyData, SceneData } from '../wire/protocol.ts';
import type { KeysInfo } from '../api/types.ts';

interface Content {
  keys: KeyData;
  scene: SceneData;
  info: KeysInfo;
}

export class KeysHandle implements Keys {
  private content: Content | null;

  constructor(content: Content) {
    this.content = content;
  }

  static of(imported: ImportedData): KeysHandle {
    const { keys, scene, report, warnings, animations, animation, project } = imported;
    const { names, times, faces: indices } = keys;
    const rest = { names: [...names], times: [...times], report, warnings, animations, animation, indices, project };
    return new KeysHandle({ keys, scene, info: { ...rest, ...scene } });
  }

  get info(): KeysInfo {
    return this.live().info;
  }

  /** What a sequence is made from. */
  get data(): KeyData {
    return this.live().keys;
  }

  get scene(): SceneData {
    return this.live().scene;
  }

  positions(key: number): Float32Array {
    return this.live().keys.positions[this.checkKey(key)]!.slice();
  }

  arrange(order: number[], times: number[], names?: string[]): KeysHandle {
    const { keys } = this.live();
    for (const key of order) this.checkKey(key);
    const checkedTimes = increasing(checkTimes(times), order.length);
    if (names && names.length !== order.length) throw countMismatch('names', names.length, order.length);
    return this.with({
      ...keys,
      names: order.map((key, place) => names?.[place] ?? keys.names[key]!),
      times: checkedTimes,
      positions: order.map((key) => keys.positions[key]!),
    });
  }

  withPose(name: string, time: number, positions: Float32Array): KeysHandle {
    const { keys } = this.live();
    const [added] = checkTimes([time]) as [number];
    const wanted = keys.positions[0]!.length;
    if (!(positions instanceof Float32Array) || positions.length !== wanted) {
      const given = positions instanceof Float32Array ? positions.length / 3 : 0;
      throw new EngineError('vertex-count-mismatch', `The pose has ${given} vertices, the keys have ${wanted / 3}.`);
    }
    const after = keys.times.findIndex((t) => t >= added);
    const place = after < 0 ? keys.times.length : after;
    const times = increasing(keys.times.toSpliced(place, 0, added), keys.times.length + 1);
    return this.with({
      ...keys,
      names: keys.names.toSpliced(place, 0, name),
      times,
      positions: keys.positions.toSpliced(place, 0, positions.slice()),
    });
  }

  dispose(): void {
    this.content = null;
  }

  private with(keys: KeyData): KeysHandle {
    const { scene, info } = this.live();
    return new KeysHandle({ keys, scene, info: { ...info, names: [...keys.names], times: [...keys.times] } });
  }

  private checkKey(key: number): number {
    const { positions } = this.live().keys;
    if (!Number.isInteger(key) || key < 0 || key >= positions.length) {
      throw invalidOption(`There is no key ${key}: the keys are 0 to ${positions.length - 1}.`);
    }
    return key;
  }

  private live(): Content {
    if (!this.content) throw disposed('import');
    return this.content;
  }
}

function increasing(times: number[], count: number): number[] {
  if (times.length !== count) throw countMismatch('times', times.length, count);
  const place = times.findIndex((t, i) => i > 0 && !(t > times[i - 1]!));
  if (place > 0) {
    const sentence =
      `Key ${place + 1} is at time ${times[place]}, not after key ${place} at ${times[place - 1]}: ` +
      'give the keys increasing times.';
    throw new EngineError('times-not-increasing', sentence, { key: place });
  }
  return times;
}

function countMismatch(what: string, given: number, wanted: number): EngineError {
  return new EngineError(
    'time-count-mismatch',
    `There are ${given} ${what} for ${wanted} keys: give one for each key.`,
  );
}
