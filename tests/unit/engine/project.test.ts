import { describe, expect, it } from 'vitest';
import { readMesh, readOptions, writeProject } from '../../../web/engine/wire/project.ts';
import { SEQUENCE_DEFAULTS, type SequenceOptions } from '../../../web/engine/api/types.ts';

const keys = { times: [0, 1], names: ['a', 'b'], frames: [0, 9] };

const mesh = { vertices: 3, faces: 1, error: 0.001 };

describe('a project', () => {
  it('restores its options, tangent poses bit for bit', () => {
    const tangent = Float32Array.from({ length: 3000 }, (_, i) => Math.sin(i) / 3);
    const options: SequenceOptions = {
      ...SEQUENCE_DEFAULTS,
      boundary: 'hermite',
      startSpeed: 0.25,
      period: 1.5,
      turns: [
        { key: 1, turns: -2 },
        { key: 1, turns: 1, component: 3 },
      ],
      endTangent: tangent,
    };
    const read = readOptions(writeProject(keys, options, mesh));
    expect(read).toEqual(options);
  });

  it('names its keys as the importer expects', () => {
    expect(JSON.parse(writeProject(keys, SEQUENCE_DEFAULTS, mesh))).toMatchObject({ version: 1, keys });
  });

  it.each([
    '',
    '{',
    'null',
    '[]',
    '{"version":2,"options":{}}',
    '{"version":1}',
    '{"version":1,"options":[]}',
    '{"version":1,"options":{"boundary":"none"}}',
    '{"version":1,"options":{"__proto__x":1}}',
    '{"version":1,"options":{"startTangent":"???"}}',
  ])('that is broken gives no options: %s', (text) => {
    expect(readOptions(text)).toBeNull();
  });

  it('states the mesh it was saved with, and null if that is missing or invalid', () => {
    expect(readMesh(writeProject(keys, SEQUENCE_DEFAULTS, mesh))).toEqual(mesh);
    for (const text of ['{}', '{"mesh": 1}', '{"mesh": {"vertices": "3", "faces": 1}}', 'no JSON'])
      expect(readMesh(text)).toBeNull();
  });
});
