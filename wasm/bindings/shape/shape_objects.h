// What the module for shapes holds by handles.
#pragma once

#include <memory>
#include <vector>

#include "core/sequence/sequence.h"

namespace shapespline::bindings {

/// A shape with the frame and the ghost that it was last evaluated into, so that no frame allocates.
struct ShapeObject {
  std::shared_ptr<SharedShape> shape;
  Frame frame;
  std::vector<float> ghost;  ///< xyz of the ghost's vertices
};

/// One of its motions.
struct MotionObject {
  Sequence sequence;
  int shape;  ///< handle
};

}  // namespace shapespline::bindings
