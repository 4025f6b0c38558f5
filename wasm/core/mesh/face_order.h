// Partitions faces for race-free accumulation by two threads.
#pragma once

#include <array>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// A range of faces in this order.
struct FaceRange {
  int begin = 0, end = 0;
};

/// Faces sorted by their last corner, so consecutive faces access neighbouring memory.
struct FaceOrder {
  std::vector<int> order;
  /// Two halves without common corners, each a multiple of four faces, followed by the rest.
  std::array<FaceRange, 3> ranges;
};

/// corners: corner indices of each face, in [0, count). Faces with the corner `shared` (-1 for none) go to the rest.
FaceOrder orderFaces(const std::vector<Triangle>& corners, int count, int shared = -1,
                     const FractionReport& onProgress = {});

}  // namespace shapespline
