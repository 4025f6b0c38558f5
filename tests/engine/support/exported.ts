/**
 * Requirements for every exported animation: the official validator reports nothing, and three.js plays the computed
 * vertices.
 */
import { validateBytes } from 'gltf-validator';
import { expect } from 'vitest';
import type { Sequence } from '../../../web/engine/api/api.ts';
import type { ExportOptions } from '../../../web/engine/api/types.ts';
import { frameAt } from './engines.ts';
import { diagonal, largestDistance } from './shapes.ts';
import { threePlayer } from './three-player.ts';

export async function exported(sequence: Sequence, options: Partial<ExportOptions>): Promise<Uint8Array> {
  const files = await sequence.export(options);
  expect(files).toHaveLength(1);
  return files[0]!.bytes;
}

export async function expectValid(bytes: Uint8Array): Promise<void> {
  const { issues } = await validateBytes(bytes);
  expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
}

/** Returns the exported file. */
export async function expectPlayed(sequence: Sequence, options: Partial<ExportOptions>): Promise<Uint8Array> {
  const { times } = await sequence.planExport(options);
  const bytes = await exported(sequence, options);
  await expectValid(bytes);
  const player = await threePlayer(bytes);
  expect(player.times).toHaveLength(times.length);
  const size = diagonal((await frameAt(sequence, times[0]!)).positions);
  for (const [index, t] of times.entries()) {
    const computed = (await frameAt(sequence, t)).positions;
    expect(largestDistance(player.positionsAt(player.times[index]!), computed)).toBeLessThan(1e-4 * size);
  }
  return bytes;
}
