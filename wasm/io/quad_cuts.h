// Matches corners of a pose's faces with the mesh's if both cut their quads differently.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Returns the matching pose corner for each corner 3 f + c of the mesh. Both lists have the same number of faces, in
/// the same order except within a quad, and refer to points: vertices at one position are one point. Two triangles with
/// a common edge may be cut along the other diagonal and start at any corner. Points of neighbouring faces decide.
/// Undecided corners keep their order. O(m log m).
std::vector<int> matchCorners(const std::vector<Triangle>& mesh, const std::vector<Triangle>& pose);

}  // namespace shapespline
