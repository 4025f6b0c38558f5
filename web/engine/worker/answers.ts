import type { CallName, RequestOf, ResultOf } from '../wire/protocol.ts';
import type { OnProgress } from './wasm-calls.ts';

/** What a worker says to the calls with these names. */
export type Answers<Names extends CallName> = {
  [K in Names]: (request: RequestOf<K>, report: OnProgress) => ResultOf<K> | Promise<ResultOf<K>>;
};
