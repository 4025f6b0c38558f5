// Generates meshes like those of artists: several parts, open boundaries, thin triangles.
#pragma once

#include <cstdint>

#include "core/sequence/keyframes.h"

namespace shapespline {

/// The bumpy capsule of bench_mesh with ragged openings, and twenty parts without common vertices: open sleeves around
/// it, curved plates, spheres, and ribbons of long thin triangles. About one face in a hundred is a sliver at an edge
/// that was cut near its end. Every key bends and twists the whole as in bench_mesh and rotates every part by up to 60
/// degrees about its own centre. Vertices and faces of all parts are in random order; times are j / (keys - 1).
/// faces: requested number, made even and at least 2,400. keys: at least 2. Equal arguments give equal faces on every
/// machine, and positions that differ at most in the last digits.
Keyframes makeBenchParts(int faces, int keys, std::uint32_t seed);

}  // namespace shapespline
