/** Keys on the caller's side: arrays independent of any worker. */
import type { Keys } from '../api/api.ts';
import { disposed, EngineError, invalidOption, vertexCountMismatch } from '../api/errors.ts';
import { checkTimes } from '../api/options.ts';
import type { KeyData } from '../wire/protocol.ts';
import type { KeysInfo } from '../api/types.ts';

export class KeyArrays implements Keys {
  private content: KeyData | null;

  constructor(content: KeyData) {
    this.content = content;
  }

  get info(): KeysInfo {
    return this.data.info;
  }

  /** The keys' data, the input of sequences. */
  get data(): KeyData {
    if (!this.content) throw disposed('import');
    return this.content;
  }

  positions(key: number): Float32Array {
    return this.data.positions[this.checkKey(key)]!.slice();
  }

  normals(): Float32Array | null {
    return this.data.normals?.slice() ?? null;
  }

  arrange(order: number[], times: number[], names?: string[]): KeyArrays {
    const { info, positions } = this.data;
    for (const key of order) this.checkKey(key);
    const checkedTimes = increasing(checkTimes(times), order.length);
    if (names && names.length !== order.length) throw countMismatch('names', names.length, order.length);
    return this.with(
      order.map((key, index) => names?.[index] ?? info.names[key]!),
      checkedTimes,
      order.map((key) => positions[key]!),
    );
  }

  withPose(name: string, time: number, pose: Float32Array): KeyArrays {
    const { info, positions } = this.data;
    const [added] = checkTimes([time]) as [number];
    const wanted = positions[0]!.length;
    if (!(pose instanceof Float32Array) || pose.length !== wanted) {
      const given = pose instanceof Float32Array ? pose.length / 3 : 0;
      throw vertexCountMismatch('The pose', given, wanted / 3);
    }
    const after = info.times.findIndex((t) => t >= added);
    const index = after < 0 ? info.times.length : after;
    const times = increasing(info.times.toSpliced(index, 0, added), info.times.length + 1);
    return this.with(info.names.toSpliced(index, 0, name), times, positions.toSpliced(index, 0, pose.slice()));
  }

  dispose(): void {
    this.content = null;
  }

  private with(names: string[], times: number[], positions: readonly Float32Array[]): KeyArrays {
    return new KeyArrays({ ...this.data, info: { ...this.info, names, times }, positions });
  }

  private checkKey(key: number): number {
    const { positions } = this.data;
    if (!Number.isInteger(key) || key < 0 || key >= positions.length) {
      throw invalidOption(`There is no key with index ${key}: the indices are 0 to ${positions.length - 1}.`);
    }
    return key;
  }
}

function increasing(times: number[], count: number): number[] {
  if (times.length !== count) throw countMismatch('times', times.length, count);
  const key = times.findIndex((t, i) => i > 0 && !(t > times[i - 1]!));
  if (key > 0) {
    const sentence =
      `Key ${key + 1} is at time ${times[key]}, not after key ${key} at ${times[key - 1]}. ` +
      'Key times must increase.';
    throw new EngineError('times-not-increasing', sentence, { key });
  }
  return times;
}

function countMismatch(what: string, given: number, wanted: number): EngineError {
  return new EngineError('time-count-mismatch', `There are ${given} ${what} for ${wanted} keys. Give one per key.`);
}
