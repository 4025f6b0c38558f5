// Generated meshes as people make them: several parts, open boundaries, thin triangles.
#pragma once

#include <cstdint>

#include "core/sequence/keyframes.h"

namespace shapespline {

/// The bumpy capsule of bench_mesh with ragged openings, and twenty parts that touch it nowhere by a vertex: open
/// sleeves round it, curved plates, spheres, and ribbons of long thin triangles. About one face in a hundred is a
/// sliver beside an edge that was cut near its end. Every key bends and twists the whole as in bench_mesh and turns
/// every part by up to 60 degrees about its own centre. Vertices and faces of all parts stand in one random order;
/// times j / (keys - 1). faces: wanted number, made even and at least 2,400; keys: at least 2. The same arguments give
/// the same faces on every machine, and positions that differ in the last digits at most.
Keyframes makeBenchParts(int faces, int keys, std::uint32_t seed);

}  // namespace shapespline
