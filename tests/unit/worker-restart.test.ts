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
  it('is followed by one retry, for any number of reports', () => {
    const { clock, restart } = setUp();
    expect(restart.tryAgain()).toBe(true);
    clock.now = 900;
    expect(restart.takesUp(new EngineError('crashed', 'Ended.'))).toBe(true);
    expect(clock.tries).toBe(1);
  });

  it('is blamed on the shape if it happens again soon, but not later', () => {
    const { clock, restart } = setUp();
    restart.tryAgain();
    clock.now = 5000;
    expect(restart.tryAgain()).toBe(false);
    clock.now = 20_000;
    expect(restart.tryAgain()).toBe(true);
    expect(clock.tries).toBe(2);
  });

  it('is distinguished from other failures', () => {
    const { clock, restart } = setUp();
    expect(restart.takesUp(new EngineError('invalid-option', 'Refused.'))).toBe(false);
    expect(clock.tries).toBe(0);
  });
});
