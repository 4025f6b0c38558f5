// Which ghost face each face follows (paper section 4.3, Fig. 6).
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/ghost/simplify.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// c(f): of the ghost faces around the ghost vertices that f's corners collapsed to, the one nearest to f's centroid in
/// the reference pose. Components without a ghost of their own follow the face that they are attached to. -1 where a
/// face has no area. Distances that differ by rounding are equal: ties fall to the lower ghost face. onProgress:
/// fraction in [0, 1], called some ten thousand faces apart.
std::vector<int> correspondingFaces(const WeldedShape& shape, const ShapeTopology& topology, const GhostMesh& ghost,
                                    const FractionReport& onProgress);

/// Squared distance from p to the triangle (a, b, c).
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace shapespline
