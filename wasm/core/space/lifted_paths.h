// A separate rotation path of each face through the keys. Neighbours determine the direction and number of turns in a
// step (rotation-strain coordinates by increments, Huang et al. 2011).
#pragma once

#include <vector>

#include "core/lri/lri.h"
#include "core/lri/welded_shape.h"
#include "core/spline/rotation_spline.h"

namespace shapespline {

struct LiftedPaths {
  RotationSplines paths;  ///< paths of R_f relative to the reference pose; faces without area rest
  /// One entry per interval between keys: faces whose increment differs by more than 180 degrees from a neighbour's.
  /// The surface tears there, because the axis of a rotation is undetermined near a full turn.
  std::vector<AmbiguousFaces> torn;
};

/// Each increment is the representative nearest to the previous face's in a spanning tree. The tree prefers edges with
/// small relative rotations. It starts at the face with the smallest rotation, and continues in another component from
/// the face that carries it.
LiftedPaths liftPaths(const WeldedShape& shape, const ShapeTopology& topology);

}  // namespace shapespline
