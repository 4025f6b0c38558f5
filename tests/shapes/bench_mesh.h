// Generated meshes of any size, for benchmarks and tests.
#pragma once

#include <cstdint>

#include "core/sequence/keyframes.h"

namespace shapespline {

/// A bumpy capsule of length 8 and radius 1 with irregular triangles, and vertices and faces in random order. The first
/// key is straight. The others are bent by up to 120 degrees and twisted by up to 180 about random directions, at times
/// j / (keys - 1). One closed manifold component; linear time.
/// faces: requested number, made even and at least 64. keys: at least 2. Equal arguments give equal faces on every
/// machine, and positions that differ at most in the last digits.
Keyframes makeBenchKeyframes(int faces, int keys, std::uint32_t seed);

/// Splits every face into four at the midpoints of its edges: the same poses at four times the resolution.
Keyframes subdivided(const Keyframes& keyframes);

}  // namespace shapespline
