import { describe, expect, it } from 'vitest';
import { createEdits } from '../../../web/play/edits.ts';
import type { Edits } from '../../../web/play/edits.ts';
import { stepped } from '../../../web/play/figures/key-handles.ts';
import { axesOf } from '../../../web/play/figures/plot.ts';
import { INITIAL } from '../../../web/play/state.ts';
import type { PlayState, LastAction } from '../../../web/play/state.ts';

function editing(start: PlayState = INITIAL): {
  edits: Edits;
  now: { state: PlayState; lastAction: LastAction | null };
} {
  const now: { state: PlayState; lastAction: LastAction | null } = { state: start, lastAction: null };
  const edits = createEdits(
    () => now.state,
    (state, lastAction) => Object.assign(now, { state, lastAction }),
    () => undefined,
  );
  return { edits, now };
}

describe('edits', () => {
  it('keep times computed from distances when the spacing becomes manual', () => {
    const { edits, now } = editing({ ...INITIAL, spacing: 'difference' });
    edits.onSpacing('hand');
    expect(now.state.spacing).toBe('hand');
    expect(now.state.keys.map(({ time }) => time)).not.toEqual(INITIAL.keys.map(({ time }) => time));
    expect(now.state.keys.at(-1)!.time).toBeCloseTo(1, 12);
  });

  it('do not change the speed of the other end', () => {
    const { edits, now } = editing();
    edits.onSpeed('end', 3);
    edits.onSpeed('start', 2);
    expect(now.state.speeds).toEqual([2, 3]);
  });

  it('move a key along time, or in the plane along its second coordinate', () => {
    const line = editing();
    line.edits.onMove(2, { along: 0.55, value: 0.4 });
    expect(line.now.state.keys[2]).toMatchObject({ time: 0.55, value: 0.4, across: INITIAL.keys[2]!.across });
    const plane = editing({ ...INITIAL, plane: true });
    plane.edits.onMove(2, { along: 0.7, value: 0.4 });
    expect(plane.now.state.keys[2]).toMatchObject({ time: 0.5, value: 0.4, across: 0.7 });
  });

  it('change nothing if the key is selected already', () => {
    const { edits, now } = editing();
    edits.onSelect(INITIAL.selected);
    expect(now.lastAction).toBeNull();
  });

  it('keep the time within the drawn range', () => {
    const { edits, now } = editing();
    edits.onTime(7);
    expect(now.state.time).toBeCloseTo(1.2, 12);
  });
});

it('an arrow key moves a key by a hundredth of the shown range, with Shift by a tenth', () => {
  const axes = axesOf({ width: 400, height: 200 }, [0, 2], [-1, 3]);
  const from = { along: 1, value: 1 };
  expect(stepped(from, { key: 'ArrowUp', shiftKey: false }, axes)).toEqual({ along: 1, value: 1.04 });
  expect(stepped(from, { key: 'ArrowLeft', shiftKey: true }, axes)).toEqual({ along: 0.8, value: 1 });
  expect(stepped(from, { key: 'a', shiftKey: false }, axes)).toBeNull();
});
