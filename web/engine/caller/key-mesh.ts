/** Converts the caller's arrays to keys, except for the mesh report, which the core makes. */
import { invalidOption } from '../api/errors.ts';
import { checkTimes } from '../api/options.ts';
import type { KeyMesh, KeysInfo } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';
import { sharedFloats } from '../wire/shared-floats.ts';

/** The core checks that they are consistent. */
export function keysOfMesh(mesh: KeyMesh): Omit<KeyData, 'info'> & { info: Omit<KeysInfo, 'report'> } {
  const { faces, poses, scene } = mesh;
  if (!(faces instanceof Uint32Array) || faces.length % 3 > 0)
    throw invalidOption('faces must be a Uint32Array with three vertex indices per face.');
  if (!poses.every(({ positions }) => positions instanceof Float32Array && positions.length % 3 === 0))
    throw invalidOption('The positions of a pose must be a Float32Array with three numbers per vertex.');
  return {
    info: {
      names: poses.map(({ name }) => String(name)),
      times: checkTimes(poses.map(({ time }) => time)),
      warnings: [],
      animations: [],
      animation: -1,
      objects: [],
      matches: [],
      faces: faces.slice(),
      offset: [0, 0, 0],
      scene: scene ?? plain(faces.length / 3),
      project: null,
      speed: null,
      played: null,
    },
    positions: poses.map(({ positions }) => {
      const own = sharedFloats(positions.length);
      own.set(positions);
      return own;
    }),
    normals: null,
  };
}

function plain(faces: number): KeysInfo['scene'] {
  return {
    uvs: null,
    seams: null,
    colors: null,
    polygons: null,
    groups: [{ start: 0, count: faces, material: -1 }],
    materials: [],
    images: [],
  };
}
