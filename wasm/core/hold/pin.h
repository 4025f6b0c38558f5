// Pins: user-placed constraints on parts of a shape.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"

namespace shapespline {

/// A key of the path of a dragged pin.
struct PathKey {
  double time = 0;
  Vec3 move = Vec3::Zero();  ///< offset from the pin's undragged position, in the shape's unit
};

/// A pin holds the vertices around an input vertex. They follow their own splines or keep their positions from a key,
/// plus the offset of an optional path.
struct Pin {
  int vertex = 0;
  double radius = 0;  ///< radius of the ball relative to the shape's size (pin_region.h); 0: the vertex's patch
  int key = -1;       ///< -1: follow their own splines
  std::vector<PathKey> path = {};
};

/// Errors: InvalidOption.
Status checkPins(const std::vector<Pin>& pins, int vertices, int keys);

}  // namespace shapespline
