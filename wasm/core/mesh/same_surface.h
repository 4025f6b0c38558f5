// Whether two lists of triangles over the same vertices are one surface, in whichever order and however cut.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Whether two faces are the same triangle with the same winding, whichever corner they start at.
bool sameTriangle(const Triangle& a, const Triangle& b);

/// Whether both lists hold the same triangles in any order, but for polygons that are cut along other diagonals: k
/// triangles over k + 2 vertices, with the same boundary in both. Windings must agree. O(m log m).
bool sameSurface(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

}  // namespace shapespline
