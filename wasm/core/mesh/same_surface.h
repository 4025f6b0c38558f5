// Compares two lists of triangles over the same vertices as surfaces, regardless of face order and polygon cuts.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Whether two faces are the same triangle with the same winding, from any first corner.
bool sameTriangle(const Triangle& a, const Triangle& b);

/// Whether both lists contain the same triangles in any order, except for polygons cut along other diagonals: k
/// triangles over k + 2 vertices with the same boundary. Windings must agree. O(m log m).
bool sameSurface(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

}  // namespace shapespline
