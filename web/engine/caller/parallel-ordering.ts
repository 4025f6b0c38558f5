/** Finds the elimination order in a second worker while the shape's worker builds LRI space. */
import { disposed } from '../api/errors.ts';
import type { RequestOf } from '../wire/protocol.ts';
import { giveUpOrder, type SharedOrder, sharedOrder } from '../wire/shared-order.ts';
import type { CoreWorker } from './worker-client.ts';

export interface ParallelOrdering {
  order: SharedOrder;
  /** Ends the worker, whether finished or not. */
  end(): void;
}

/** If this worker fails, the shape reports its own failure or finds the order itself. */
export function orderInParallel(client: CoreWorker, request: RequestOf<'encode'>): ParallelOrdering {
  const order = sharedOrder(request.positions[0]!.length / 3);
  const end = (): void => {
    giveUpOrder(order);
    client.terminate(disposed('engine'));
  };
  client.call('order', { ...request, order }).then(end, end);
  return { order, end };
}
