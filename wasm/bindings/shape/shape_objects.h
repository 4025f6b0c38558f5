// Objects behind the handles of the shape module.
#pragma once

#include <memory>
#include <vector>

#include "core/sequence/sequence.h"

namespace shapespline::bindings {

/// A shape with the buffers of its last frame and ghost, so frames allocate nothing.
struct ShapeObject {
  std::shared_ptr<SharedShape> shape;
  Frame frame;
  std::vector<float> ghost;  ///< xyz of the ghost's vertices
};

/// A motion of a shape.
struct MotionObject {
  Sequence sequence;
  int shape;  ///< handle of the shape
};

}  // namespace shapespline::bindings
