import { expect, test } from 'vitest';
import { ThreadChoice } from '../../../web/engine/worker/thread-choice.ts';

/** Simulates frames with these times for one and two threads; returns the threads of each frame. */
function play(choice: ThreadChoice, ms: (threads: 1 | 2, frame: number) => number, frames: number): (1 | 2)[] {
  return Array.from({ length: frames }, (_, frame) => {
    const { threads } = choice;
    choice.took(ms(threads, frame));
    return threads;
  });
}

test('first frames use one thread and two alternately', () => {
  expect(play(new ThreadChoice(), () => 10, 14)).toEqual(Array.from({ length: 14 }, (_, frame) => (frame % 2 ? 2 : 1)));
});

test('two threads are kept if they are faster, despite single slow frames', () => {
  const choice = new ThreadChoice();
  play(choice, (threads, frame) => (frame < 4 || frame === 7 || frame === 11 ? 100 : threads === 2 ? 7 : 10), 14);
  expect(play(choice, () => 1000, 5)).toEqual([2, 2, 2, 2, 2]);
});

test('one thread is kept if a second one is hardly faster or slower', () => {
  for (const two of [9.8, 10, 30]) {
    const choice = new ThreadChoice();
    play(choice, (threads) => (threads === 2 ? two : 10), 14);
    expect(play(choice, () => 1, 3)).toEqual([1, 1, 1]);
    expect(choice.chosen).toBe(1);
  }
});

test('one fast frame does not decide for a second thread', () => {
  const choice = new ThreadChoice();
  play(choice, (threads, frame) => (frame === 5 || frame === 9 ? 2 : threads === 2 ? 12 : 10), 14);
  expect(choice.threads).toBe(1);
});

test('two threads that have become slower than one was are compared with it at once', () => {
  const choice = new ThreadChoice();
  play(choice, (threads) => (threads === 2 ? 7 : 10), 14 + 20);
  expect(choice.chosen).toBe(2);
  play(choice, (threads) => (threads === 2 ? 14 : 10), 5 + 10);
  expect(play(choice, () => 10, 5)).toEqual([1, 1, 1, 1, 1]);
});

test('single slow frames change nothing', () => {
  const choice = new ThreadChoice();
  play(choice, (threads) => (threads === 2 ? 7 : 10), 14);
  expect(play(choice, (_, frame) => (frame % 5 === 4 ? 7 : 14), 100)).not.toContain(1);
});

test('two threads that have become faster than one are found, and one that has become as fast', () => {
  const choice = new ThreadChoice();
  play(choice, (threads) => (threads === 2 ? 20 : 10), 14);
  play(choice, (threads) => (threads === 2 ? 7 : 10), 500);
  expect(choice.chosen).toBe(2);
  play(choice, (threads) => (threads === 2 ? 7 : 6), 1000);
  expect(choice.chosen).toBe(1);
});

test('the slower choice is tried less and less often', () => {
  const choice = new ThreadChoice();
  const threads = play(choice, (number) => (number === 2 ? 20 : 10), 20_000);
  const lost = (from: number, to: number): number =>
    threads.slice(from, to).filter((number) => number === 2).length / (to - from);
  expect(lost(14, 2000)).toBeLessThan(0.02);
  expect(lost(2000, 20_000)).toBeLessThan(0.002);
});
