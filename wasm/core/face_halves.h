// Faces cut into two halves that two can add up at their corners at the same time.
#pragma once

#include <vector>

#include "core/types.h"

namespace shapespline {

/// order: the faces of the first half, those of the second, which have no corner in common with them, and the rest.
struct FaceHalves {
  std::vector<int> order;
  int first = 0, second = 0;  ///< how many; multiples of four
};

/// order: all faces, neighbours near each other, which keep their order within each half. corners: of each face, in [0, count). Faces
/// with the corner `shared` (or -1 for none) go to the rest.
FaceHalves halveFaces(const std::vector<int>& order, const std::vector<Triangle>& corners, int count, int shared = -1);

}  // namespace shapespline
