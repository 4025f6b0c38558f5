// Faces in an order in which two can add up at their corners at the same time.
#pragma once

#include <array>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// A range of faces in their order.
struct FaceRange {
  int begin = 0, end = 0;
};

/// Faces sorted by the last of their corners: neighbours in this order add to neighbouring places and find all that
/// lies before theirs at hand.
struct FaceOrder {
  std::vector<int> order;
  /// Two halves without a common corner, each a multiple of four faces, then the rest.
  std::array<FaceRange, 3> ranges;
};

/// corners: of each face, in [0, count). Faces with the corner `shared` (or -1 for none) go to the rest.
FaceOrder orderFaces(const std::vector<Triangle>& corners, int count, int shared = -1,
                     const FractionReport& onProgress = {});

}  // namespace shapespline
