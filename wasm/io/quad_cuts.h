// Which corners of a pose's faces are those of the mesh's, where both cut their quads in ways of their own.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Of each corner 3 f + c of the mesh: the corner of the pose that stands for it. Both lists hold as many faces, in the
/// same order but for the two triangles of a quad, and name points: vertices at one place are one point. Two triangles
/// with a common edge may be cut along the other diagonal, and then start at any corner; what the faces around tell of
/// their points says which is which. Corners that nothing tells stay as they are in the lists. O(m log m).
std::vector<int> matchCorners(const std::vector<Triangle>& mesh, const std::vector<Triangle>& pose);

}  // namespace shapespline
