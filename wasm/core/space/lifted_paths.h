// The rotation of each face through the keys, by itself: which way and how often it turned in a step follows from its
// neighbours (rotation-strain coordinates by increments, Huang et al. 2011).
#pragma once

#include <vector>

#include "core/lri/lri.h"
#include "core/lri/welded_shape.h"
#include "core/spline/rotation_spline.h"

namespace shapespline {

struct LiftedPaths {
  RotationSplines paths;  ///< of R_f against the reference pose; faces without area rest
  /// One per interval between keys: faces whose increment differs by more than half a turn from a neighbour's. The
  /// surface tears there: near a whole turn the axis of a rotation says nothing.
  std::vector<AmbiguousFaces> torn;
};

/// Each increment is the representative nearest the one of the face before it in a spanning tree that crosses edges
/// where faces turn least against each other. The tree begins at the face that turns least; it goes on in another
/// component from the face that carries that component.
LiftedPaths liftPaths(const WeldedShape& shape, const ShapeTopology& topology);

}  // namespace shapespline
