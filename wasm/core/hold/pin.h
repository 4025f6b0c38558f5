// Places of a shape that are held by hand, and where.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"

namespace shapespline {

/// A key of a path that a pin was dragged along.
struct PathKey {
  double time = 0;
  Vec3 move = Vec3::Zero();  ///< from where the pin would be, in the shape's unit
};

/// The vertices around one of the input's. They follow their own splines, or stay where they are in a key; moved along
/// a path, where there is one.
struct Pin {
  int vertex = 0;
  double radius = 0;  ///< of the ball, over the shape's size (pin_region.h); 0: the vertex's patch
  int key = -1;       ///< -1: they follow their own splines
  std::vector<PathKey> path = {};
};

/// Errors: InvalidOption.
Status checkPins(const std::vector<Pin>& pins, int vertices, int keys);

}  // namespace shapespline
