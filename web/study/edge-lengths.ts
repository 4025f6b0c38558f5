/** Lengths of a mesh's edges. */

/** Two vertices per edge, each edge once. `faces`: 3 x faces. */
export function edgesOf(faces: Uint32Array): Uint32Array {
  const vertices = faces.reduce((most, vertex) => Math.max(most, vertex), 0) + 1;
  const edges = new Set<number>();
  for (let f = 0; f < faces.length; f += 3)
    for (let c = 0; c < 3; c += 1) {
      const [a, b] = [faces[f + c]!, faces[f + ((c + 1) % 3)]!];
      if (a !== b) edges.add(Math.min(a, b) * vertices + Math.max(a, b));
    }
  return Uint32Array.from([...edges].flatMap((edge) => [Math.floor(edge / vertices), edge % vertices]));
}

/** `positions`: 3 x vertices. */
export function edgeLengths(edges: Uint32Array, positions: Float32Array): Float64Array {
  const lengths = new Float64Array(edges.length / 2);
  for (let edge = 0; edge < lengths.length; edge += 1) {
    const [a, b] = [3 * edges[2 * edge]!, 3 * edges[2 * edge + 1]!];
    const along = (axis: number): number => positions[b + axis]! - positions[a + axis]!;
    lengths[edge] = Math.hypot(along(0), along(1), along(2));
  }
  return lengths;
}
