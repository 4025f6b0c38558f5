/** Converts the caller's arrays to keys, except for the mesh report, which the core makes. */
import { EngineError, invalidOption } from '../api/errors.ts';
import { copied, isRecord, timeProblem } from '../api/options.ts';
import type { KeyMesh, KeysInfo } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';
import { sharedFloats } from '../wire/shared-floats.ts';

/** The core checks that the poses are consistent, and `check-scene` checks the scene. */
export function keysOfMesh(mesh: KeyMesh): Omit<KeyData, 'info'> & { info: Omit<KeysInfo, 'report'> } {
  if (!isRecord(mesh)) throw invalidOption('Give a mesh as { faces, poses }.');
  const { faces, poses, scene } = mesh as KeyMesh;
  if (!(faces instanceof Uint32Array) || faces.length % 3 > 0)
    throw invalidOption('faces must be a Uint32Array with three vertex indices per face.');
  if (!Array.isArray(poses)) throw invalidOption('poses must be an array of { name, time, positions }.');
  poses.forEach(checkPose);
  const vertices = (poses[0]?.positions.length ?? 0) / 3;
  if (poses.length > 0) checkFaces(faces, vertices);
  return {
    info: {
      names: poses.map(({ name }) => String(name)),
      times: poses.map(({ time }) => time),
      warnings: [],
      animations: [],
      animation: -1,
      objects: [],
      matches: [],
      faces: copied(faces),
      offset: [0, 0, 0],
      scene: copied(scene) ?? plain(faces.length / 3),
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

function checkPose(pose: unknown, index: number): void {
  const what = `poses[${index}]`;
  if (!isRecord(pose)) throw invalidOption(`${what} must be { name, time, positions }.`);
  const { name, time, positions } = pose;
  if (typeof name === 'object' || typeof name === 'function') throw invalidOption(`${what}.name must be a string.`);
  const wrong = timeProblem(time);
  if (wrong) throw invalidOption(`${what}.time ${wrong}.`);
  if (!(positions instanceof Float32Array) || positions.length === 0 || positions.length % 3 > 0)
    throw invalidOption(
      `${what}.positions must be a Float32Array with three numbers per vertex. An array that was transferred is empty.`,
    );
}

function checkFaces(faces: Uint32Array, vertices: number): void {
  if (faces.length === 0) return; // also of a transferred array; the core reports it
  const corner = faces.findIndex((vertex) => vertex >= vertices);
  if (corner < 0) return;
  const [face, vertex] = [Math.floor(corner / 3), faces[corner]!];
  const count = (n: number): string => n.toLocaleString('en');
  throw new EngineError(
    'index-out-of-range',
    `Face ${count(face)} refers to vertex ${count(vertex)}, but there are ${count(vertices)} vertices (0 to ` +
      `${count(vertices - 1)}).`,
    { face, vertex },
  );
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
