// Objects that the module for shapes keeps by handle.
#pragma once

#include <memory>
#include <vector>

#include "core/sequence/sequence.h"

namespace shapespline::bindings {

/// A shape with the buffers of its last frame and ghost, so no frame allocates.
struct ShapeObject {
  std::shared_ptr<SharedShape> shape;
  Frame frame;
  std::vector<float> ghost;  ///< xyz of the ghost's vertices
};

/// A motion of a shape.
struct MotionObject {
  Sequence sequence;
  int shape;  ///< handle
};

}  // namespace shapespline::bindings
