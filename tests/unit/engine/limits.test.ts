/**
 * Limits that both engine and core check have equal numbers. They exist in both languages because the engine checks
 * before starting a worker, and the core does not rely on that.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../../..');

/** The value of a constant in a TypeScript or C++ source file. */
function constantIn(file: string, name: string): number {
  const text = readFileSync(path.join(root, file), 'utf8');
  const found = new RegExp(`\\b${name} = (-?[\\d][\\d.e'_]*)[,;]`).exec(text)?.[1];
  if (found === undefined) throw new Error(`${file} has no ${name} = NUMBER`);
  return Number(found.replace(/['_]/g, ''));
}

const TABLE = 'web/engine/api/option-table.ts';
const JSON_TS = 'web/engine/api/gltf-json.ts';
const LIMITS = 'wasm/io/base/limits.h';

describe('a limit of the engine equals that of the core', () => {
  it.each([
    [TABLE, 'MAX_TURNS', 'wasm/core/sequence/motion.cpp', 'maxTurns'],
    [TABLE, 'MAX_TIME', 'wasm/core/spline/key_times.cpp', 'farthestTime'],
    [TABLE, 'MAX_KEYS', 'wasm/io/base/sample_times.cpp', 'maxKeys'],
    ['web/engine/caller/fitted-motion.ts', 'MAX_MOTION_KEYS', 'wasm/core/sequence/shared_shape.cpp', 'maxKeys'],
    ['web/engine/caller/export-plan.ts', 'MAX_WEIGHTS', LIMITS, 'maxElements'],
    [JSON_TS, 'DEEPEST', LIMITS, 'deepestJson'],
    [JSON_TS, 'MAX_OBJECTS', LIMITS, 'maxJsonObjects'],
    [JSON_TS, 'MAX_VALUES', LIMITS, 'maxJsonValues'],
  ])('%s %s', (file, name, coreFile, coreName) => {
    expect(constantIn(file, name)).toBe(constantIn(coreFile, coreName));
  });
});
