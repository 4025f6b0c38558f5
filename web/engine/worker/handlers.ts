import type { CallName, RequestOf, ResultOf } from '../wire/protocol.ts';
import type { OnProgress } from './wasm-calls.ts';

/** The worker's handlers of the calls with these names. */
export type Handlers<Names extends CallName> = {
  [K in Names]: (request: RequestOf<K>, report: OnProgress) => ResultOf<K> | Promise<ResultOf<K>>;
};
