// Finds the vertices of a pin.
#pragma once

#include <vector>

#include "core/hold/hold_input.h"

namespace shapespline {

/// Welded vertices, ascending: those in a ball around `vertex` in the reference pose that are connected to it by faces
/// inside, or, for radius 0, those of the patch of its first face. radius: relative to the size of the reference pose,
/// twice the distance of its farthest vertex from its centroid.
std::vector<int> pinnedVertices(const HoldInput& input, int vertex, double radius);

}  // namespace shapespline
