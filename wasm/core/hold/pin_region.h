// Which vertices a pin holds.
#pragma once

#include <vector>

#include "core/hold/hold_input.h"

namespace shapespline {

/// Welded vertices, ascending: those within a ball around `vertex` in the reference pose that faces join to it there,
/// or, with radius 0, those of the patch of its first face. radius: over the size of the reference pose, twice the
/// distance of its farthest vertex from its centroid.
std::vector<int> pinnedVertices(const HoldInput& input, int vertex, double radius);

}  // namespace shapespline
