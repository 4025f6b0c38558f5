/** A closed skin of rings between two poles, as on a lathe. */

export interface Skin {
  /** Vertex indices, 3 x faces. */
  faces: Uint32Array;
  /**
   * Texture coordinates around and along, in [0, 1], 2 x vertices. The two columns at the seam have separate vertices.
   */
  uvs: Float32Array;
  rings: number;
  around: number;
}

/** Position of a ring's vertices: `along` in [0, 1] from pole to pole, then `angle` around. */
export type Place = (along: number) => (angle: number) => readonly [x: number, y: number, z: number];

export function skin(rings: number, around: number): Skin {
  const columns = around + 1;
  const last = rings * columns + 1;
  const uvs = new Float32Array(2 * (last + 1));
  const faces = new Uint32Array(6 * around * rings);
  uvs.set([0.5, 0], 0);
  uvs.set([0.5, 1], 2 * last);
  for (let i = 0; i < rings; i += 1)
    for (let j = 0; j < columns; j += 1) uvs.set([j / around, alongOf(i, rings)], 2 * vertexOf(i, j, columns));
  let at = 0;
  const add = (a: number, b: number, c: number): void => {
    faces.set([a, b, c], at);
    at += 3;
  };
  for (let j = 0; j < around; j += 1) {
    add(0, vertexOf(0, j, columns), vertexOf(0, j + 1, columns));
    for (let i = 0; i + 1 < rings; i += 1) {
      const [a, b] = [vertexOf(i, j, columns), vertexOf(i, j + 1, columns)];
      const [c, d] = [vertexOf(i + 1, j, columns), vertexOf(i + 1, j + 1, columns)];
      // Diagonals alternate, so no direction of twist is favoured.
      if ((i + j) % 2 === 0) {
        add(a, c, b);
        add(b, c, d);
      } else {
        add(a, c, d);
        add(a, d, b);
      }
    }
    add(last, vertexOf(rings - 1, j + 1, columns), vertexOf(rings - 1, j, columns));
  }
  return { faces, uvs, rings, around };
}

/** The skin's vertices, xyz interleaved. */
export function placed({ rings, around }: Skin, place: Place): Float32Array {
  const columns = around + 1;
  const positions = new Float32Array(3 * (rings * columns + 2));
  positions.set(place(0)(0), 0);
  positions.set(place(1)(0), positions.length - 3);
  for (let i = 0; i < rings; i += 1) {
    const onRing = place(alongOf(i, rings));
    for (let j = 0; j < columns; j += 1)
      positions.set(onRing((2 * Math.PI * (j % around)) / around), 3 * vertexOf(i, j, columns));
  }
  return positions;
}

function alongOf(ring: number, rings: number): number {
  return (ring + 1) / (rings + 1);
}

function vertexOf(ring: number, column: number, columns: number): number {
  return 1 + ring * columns + column;
}
