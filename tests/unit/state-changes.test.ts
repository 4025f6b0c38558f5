import { describe, expect, it } from 'vitest';
import { changesBetween } from '../../web/app/session/state-changes.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import type { AppState } from '../../web/model/state.ts';

const named = (after: AppState, before: AppState = EMPTY_STATE): string[] =>
  Object.entries(changesBetween(before, after)).flatMap(([name, changed]) => (changed ? [name] : []));

const withView = (change: Partial<AppState['view']>): AppState => ({
  ...EMPTY_STATE,
  view: { ...EMPTY_STATE.view, ...change },
});

describe('changes of the state', () => {
  it.each([
    ['nothing', { ...EMPTY_STATE }, []],
    ['the document', { ...EMPTY_STATE, doc: { ...EMPTY_STATE.doc } }, ['motions']],
    ['methods to compare', withView({ compare: ['linear'] }), ['motions']],
    ['the wireframe', withView({ wireframe: !EMPTY_STATE.view.wireframe }), ['look']],
    ['the colouring, of which measures are drawn too', withView({ colouring: 'patches' }), ['look', 'drawing']],
    ['onion skins', withView({ onion: !EMPTY_STATE.view.onion }), ['drawing']],
    ['the time', { ...EMPTY_STATE, time: 0.25 }, ['time']],
    ['other files', { ...EMPTY_STATE, source: { kind: 'files' as const, names: ['a.glb'] } }, ['opened']],
  ])('of %s', (_, after, names) => {
    expect(named(after)).toEqual(names);
  });

  it('of playback have a start and an end', () => {
    const playing = { ...EMPTY_STATE, play: { ...EMPTY_STATE.play, playing: true } };
    expect(named(playing)).toEqual(['started']);
    expect(named(EMPTY_STATE, playing)).toEqual(['stopped']);
    expect(named({ ...playing }, playing)).toEqual([]);
  });
});
