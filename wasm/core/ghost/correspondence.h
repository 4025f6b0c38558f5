// Assigns a ghost face to each face (paper section 4.3, Fig. 6).
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/ghost/simplify.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// c(f): among the ghost faces around the ghost vertices of f's corners, the one nearest to f's centroid in the
/// reference pose. Components without a ghost follow the face that carries them. -1 for a face without area. Distances
/// that differ by rounding count as equal, and ties go to the lower ghost face. onProgress: fraction in [0, 1], called
/// every few ten thousand faces.
std::vector<int> correspondingFaces(const WeldedShape& shape, const ShapeTopology& topology, const GhostMesh& ghost,
                                    const FractionReport& onProgress);

/// Squared distance from p to the triangle (a, b, c).
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace shapespline
