/** Requests for content, and the resulting state. */
import { describe, expect, it } from 'vitest';
import { PosePool } from '../../web/app/session/pose-pool.ts';
import type { LoadedKeys } from '../../web/app/session/workspace.ts';
import {
  animationRequest,
  leftRequest,
  momentsRequest,
  objectsRequest,
  pickedRequest,
  sampleRequest,
  turnRequest,
} from '../../web/app/sources/open-request.ts';
import type { OpenRequest, Present } from '../../web/app/sources/open-request.ts';
import { openedState, startOf } from '../../web/app/sources/start-state.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import type { Sample } from '../../web/app/sources/samples.ts';
import { KeyArrays } from '../../web/engine/caller/keyframes.ts';
import type { KeyData } from '../../web/engine/wire/protocol.ts';
import { setMotion } from '../../web/model/edits.ts';
import type { AppState, LoopMode } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const sample: Sample = {
  ...{ id: 'box', title: 'Box', description: '', files: ['box.glb'], made: false, names: ['one', 'two'] },
  ...{ times: [0, 2], boundary: 'periodic', hold: 'on' },
};
const input = [{ name: 'box.obj', bytes: new Uint8Array(1) }];
const files: AppState = {
  ...EMPTY_STATE,
  source: { kind: 'files', names: ['box.obj'] },
  project: 'mine',
  doc: setMotion(docOfKeys(keyRef(0, 'a', 0), keyRef(2, 'added', 1)), { boundary: 'hermite' }),
  time: 0.75,
  view: { ...EMPTY_STATE.view, wireframe: true, split: 0.5, compare: ['linear'] },
};
const present: Present = { files: input, options: { animation: 1, sample: [0, 1], up: 'y', unit: 2 }, state: files };
const pose = { name: 'added', positions: Float32Array.of(1, 2, 3) };
const work = { ...present, poses: [pose], history: { past: [], future: [] } };

/** A tetrahedron with two poses; `read`: the initial document of its files. */
function imported(animation = -1): PosePool {
  const faces = Uint32Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2);
  const info = { names: ['a', 'b'], times: [0, 1], offset: [0, 0, 0], animation, animations: [], project: null };
  const corners = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const keys = { info: { ...info, faces, report: { components: 1 }, speed: null }, positions: [corners, corners] };
  return new PosePool(new KeyArrays(keys as unknown as KeyData));
}
const read = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));

/** The start and the state that a request produces from these files. */
function met(request: OpenRequest, before: AppState = files, animation = -1) {
  const pool = imported(animation);
  const poses = [{ name: 'added', positions: new Float32Array(12).fill(2) }];
  const start = startOf(request, read, pool, request.turn ? { ...work, poses } : null);
  const opening: LoadedKeys & typeof start = { ...start, info: pool.keys.info, pool };
  return { pool, start, state: openedState(request, opening, before, [0, 1], false) };
}

describe('a request', () => {
  it('of a sample has its times, and no project', () => {
    const request = sampleRequest(sample, input, null, 'on');
    expect(request).toMatchObject({ input, options: { keyTimes: [0, 2] }, project: null, source: { id: 'box' } });
    expect(sampleRequest({ ...sample, times: null }, input, null, null)).toMatchObject({ options: {}, step: null });
  });

  it('of picked files reads them when it is processed', async () => {
    const request = pickedRequest([{ name: 'a/b.obj', file: new File(['v'], 'b.obj') }]);
    expect(request).toMatchObject({ source: { kind: 'files', names: ['a/b.obj'] }, picked: true, step: 'on' });
    const bytes = typeof request.input === 'function' && request.input(() => undefined, new AbortController().signal);
    expect(await bytes).toEqual([{ name: 'a/b.obj', bytes: Uint8Array.of(118) }]);
  });

  it('of earlier content has its project and its sample', () => {
    expect(leftRequest(work, [sample], 'back')).toMatchObject({ project: 'mine', begins: 'files', step: 'back' });
    const state: AppState = { ...EMPTY_STATE, source: { kind: 'sample', id: 'box' } };
    expect(leftRequest({ ...work, state }, [sample], 'on').begins).toBe(sample);
    expect(leftRequest({ ...work, state }, [], 'on').begins).toBe('files');
  });

  it('of the open files keeps their orientation, with the requested options', () => {
    const orientation = { up: 'y', unit: 2 };
    expect(momentsRequest(present, 0, [1, 3])).toMatchObject({
      ...{ options: { ...orientation, animation: 0, sample: [1, 3] }, stays: true, project: 'mine' },
    });
    const animation = animationRequest(present);
    expect(animation.options).toEqual({ ...orientation, animation: 0 });
    expect([animation.stays, animation.begins]).toEqual([true, 'files']);
    const objects = objectsRequest(present, ['arm']);
    expect(objects.options).toEqual({ ...present.options, objects: ['arm'] });
    expect(objects.stays).toBeUndefined();
    expect(objectsRequest({ ...present, options: objects.options }, []).options).toEqual(present.options);
  });

  it('of a rotation has the previous orientation', () => {
    const request = turnRequest(present, { up: 'z', unit: 1 }, 'on');
    expect(request.turn).toEqual({ before: { up: 'y', unit: 2 }, after: { up: 'z', unit: 1 } });
    expect(request.options).toEqual({ ...present.options, up: 'z', unit: 1 });
  });
});

describe('the state after a request', () => {
  it('plays animations in a loop and poses back and forth, or once if chosen', () => {
    const loopOf = (loop: LoopMode, animation: number): LoopMode =>
      met(pickedRequest([]), { ...files, play: { ...files.play, loop } }, animation).state.play.loop;
    expect([loopOf('bounce', 0), loopOf('loop', -1)]).toEqual(['loop', 'bounce']);
    expect([loopOf('once', 0), loopOf('once', -1)]).toEqual(['once', 'once']);
  });

  it('of a sample: its ends and names, without a divider, with the same look, playing from the first key', () => {
    const { start, state } = met(sampleRequest(sample, input, null, 'on'));
    expect(state.doc).toBe(start.initial);
    expect(state.doc.keys.map(({ name }) => name)).toEqual(['one', 'two']);
    expect(state.doc.motion).toMatchObject({ boundary: 'periodic', hold: 'on' });
    expect(state.view).toMatchObject({ wireframe: true, split: null, compare: [], camera: null });
    expect([state.time, state.play.playing, state.project]).toEqual([0, true, null]);
  });

  it('of a link: its state, except a camera inside the shape', () => {
    const outside = readPermalink('sample=box&t=0.5&camera=5,0,0,0,0,0&keys=0@0,1@2&floor=0')!;
    const { start, state } = met(sampleRequest(sample, input, outside, 'on'));
    expect(start.initial.keys[1]!.time).toBe(1);
    expect(state.doc.keys[1]!.time).toBe(2);
    expect([state.time, state.play.playing, state.view.floor, state.view.wireframe]).toEqual([
      0.5,
      false,
      false,
      false,
    ]);
    expect(state.view.camera).toEqual(start.camera);
    expect(start.camera?.position).toEqual([5, 0, 0]);
    const inside = met(sampleRequest(sample, input, readPermalink('sample=box&camera=0.1,0.1,0.1,1,1,1'), 'on'));
    expect([inside.start.camera, inside.state.view.camera, inside.start.link?.unfit]).toEqual([null, null, ['camera']]);
  });

  it('of picked files: a new project', () => {
    const { state } = met(pickedRequest([{ name: 'b.obj', file: new File([], 'b.obj') }]));
    expect([state.source, state.project]).toEqual([{ kind: 'files', names: ['b.obj'] }, expect.any(String)]);
    expect(state.project).not.toBe('mine');
  });

  it('of earlier content: the same state, paused', () => {
    const poses = [{ name: 'added', positions: new Float32Array(12) }];
    const playing = { ...files, play: { ...files.play, playing: true } };
    const { pool, state } = met(leftRequest({ ...work, poses, state: playing }, [], 'on'), EMPTY_STATE);
    expect(state).toEqual({ ...files, play: { ...files.play, playing: false } });
    expect(pool.count).toBe(3);
  });

  it('of other keys of the files: the same settings, time, view and playback', () => {
    const { state } = met(momentsRequest(present, 0, [0, 1]));
    expect(state.doc).toEqual({ ...read, motion: files.doc.motion });
    expect(state).toEqual({ ...files, doc: state.doc });
    expect(met(objectsRequest(present, ['arm'])).state).toMatchObject({ time: 0, view: { split: null } });
  });

  it('has a frame rate only of its own files', () => {
    const framed = { ...files, play: { ...files.play, fps: 12 } };
    const rateOf = (request: OpenRequest) => met(request, framed).state.play.fps;
    expect([rateOf(pickedRequest([])), rateOf(sampleRequest(sample, input, null, 'on'))]).toEqual([null, null]);
    expect([rateOf(objectsRequest(present, ['arm'])), rateOf(momentsRequest(present, 0, [0, 1]))]).toEqual([12, 12]);
  });

  it('of a rotation: the same document, with rotated added poses', () => {
    const { pool, start, state } = met(turnRequest(present, { up: 'z', unit: 1 }, 'on'));
    expect(start.doc).toEqual(files.doc);
    expect(state.time).toBe(files.time);
    expect([...pool.keys.positions(2).slice(0, 3)]).toEqual([1, 1, -1]);
  });
});
