/** Engines for a test file, disposed of after it. */
import { afterAll, expect } from 'vitest';
import type { Engine, Keys, Motion, Sequence } from '../../../web/engine/api/api.ts';
import { EngineError } from '../../../web/engine/api/errors.ts';
import type { EngineUrls } from '../../../web/engine/api/configure.ts';
import { createEngine } from '../../../web/engine/node.ts';
import type { Frame, SequenceOptions } from '../../../web/engine/api/types.ts';
import { poseFiles } from './glb.ts';
import { bar, bent, type Mesh } from './shapes.ts';

const engines: Engine[] = [];

export function testEngine(urls?: EngineUrls): Engine {
  const engine = createEngine(urls);
  engines.push(engine);
  return engine;
}

afterAll(() => {
  for (const engine of engines.splice(0)) engine.dispose();
});

export interface Bend {
  mesh: Mesh;
  poses: Float32Array[];
  keys: Keys;
}

/** A bar bent by 0, 60 and 120 degrees: keys at 0, 0.5 and 1. */
export async function bendKeys(engine: Engine, mesh = bar()): Promise<Bend> {
  const poses = [0, 60, 120].map((degrees) => bent(mesh, degrees));
  return { mesh, poses, keys: await engine.importKeyframes(poseFiles(mesh, poses), { keyTimes: [0, 0.5, 1] }) };
}

export async function bendSequence(
  engine: Engine,
  options?: Partial<SequenceOptions>,
): Promise<Bend & { sequence: Sequence }> {
  const bend = await bendKeys(engine);
  return { ...bend, sequence: await engine.createSequence(bend.keys, options) };
}

/** The frame at t; fails if a newer request replaced it. */
export async function frameAt(sequence: Pick<Motion, 'evaluate'>, t: number): Promise<Frame> {
  const frame = await sequence.evaluate(t);
  if (!frame) throw new Error(`the frame at ${t} was overtaken`);
  return frame;
}

/** The rejection of a promise, which must be an EngineError. */
export async function failureOf(work: Promise<unknown>): Promise<EngineError> {
  const outcome = await work.then(
    () => 'no error',
    (error: unknown) => error,
  );
  expect(outcome).toBeInstanceOf(EngineError);
  return outcome as EngineError;
}
