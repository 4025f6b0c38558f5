/** Two workers exchange the elimination order through shared memory alone. */
import { describe, expect, it } from 'vitest';
import { awaitedOrder, giveUpOrder, provideOrder, sharedOrder } from '../../../web/engine/wire/shared-order.ts';

describe('shared order', () => {
  it('is the found order if it has the right number of unknowns', () => {
    const order = sharedOrder(5);
    provideOrder(order, () => Int32Array.of(2, 0, 1));
    expect([...awaitedOrder(order)!]).toEqual([2, 0, 1]);
    giveUpOrder(order); // the order is given up too late
    expect([...awaitedOrder(order)!]).toEqual([2, 0, 1]);
  });

  it('is empty if no worker started, if it was abandoned and if it failed', () => {
    expect(awaitedOrder(sharedOrder(3))).toBeNull();
    const given = sharedOrder(3);
    giveUpOrder(given);
    expect(awaitedOrder(given)).toBeNull();
    // A later worker must not start, because it may end midway without notice.
    provideOrder(given, () => {
      throw new Error('begun');
    });
    expect(awaitedOrder(given)).toBeNull();
    const failed = sharedOrder(3);
    const fail = (): never => {
      throw new Error('no area');
    };
    expect(() => provideOrder(failed, fail)).toThrow('no area');
    expect(awaitedOrder(failed)).toBeNull();
  });
});
