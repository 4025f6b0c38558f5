// Generated meshes of any size, for benchmarks and tests.
#pragma once

#include <cstdint>

#include "core/sequence/keyframes.h"

namespace shapespline {

/// A bumpy capsule of length 8 and radius 1 with irregular triangles, its vertices and faces in random order. The first
/// key is straight; the others are bent by up to 120 and twisted by up to 180 degrees about directions of their own, at
/// times j / (keys - 1). One closed manifold component; linear time.
/// faces: wanted number, made even and at least 64; keys: at least 2. The same arguments give the same faces on every
/// machine, and positions that differ in the last digits at most.
Keyframes makeBenchKeyframes(int faces, int keys, std::uint32_t seed);

/// Every face split into four at the midpoints of its edges: the same poses at four times the resolution.
Keyframes subdivided(const Keyframes& keyframes);

}  // namespace shapespline
