import { describe, expect, it } from 'vitest';
import { WorkerRestart } from '../../web/app/session/worker-restart.ts';
import { EngineError } from '../../web/engine/api/errors.ts';

function setUp() {
  const clock = { now: 0, tries: 0 };
  return {
    clock,
    restart: new WorkerRestart(
      () => {
        clock.tries += 1;
      },
      () => clock.now,
    ),
  };
}

describe('the end of a worker', () => {
  it('is followed by one other try, however many report it', () => {
    const { clock, restart } = setUp();
    expect(restart.tryAgain()).toBe(true);
    clock.now = 900;
    expect(restart.takesUp(new EngineError('crashed', 'Ended.'))).toBe(true);
    expect(clock.tries).toBe(1);
  });

  it('is a matter of the shape when it comes again soon, and not when it comes late', () => {
    const { clock, restart } = setUp();
    restart.tryAgain();
    clock.now = 5000;
    expect(restart.tryAgain()).toBe(false);
    clock.now = 20_000;
    expect(restart.tryAgain()).toBe(true);
    expect(clock.tries).toBe(2);
  });

  it('is not what other failures are', () => {
    const { clock, restart } = setUp();
    expect(restart.takesUp(new EngineError('invalid-option', 'Refused.'))).toBe(false);
    expect(clock.tries).toBe(0);
  });
});
