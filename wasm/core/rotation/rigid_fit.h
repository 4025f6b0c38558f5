// Fits a rigid motion between two sets of points.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// The rotation from `from` to `to` (least squares, Kabsch), and the largest distance that remains after the rigid fit.
struct RigidFit {
  Mat3 rotation;
  double largestDistance = 0;
};
RigidFit fitRigid(const Positions& from, const Positions& to);

}  // namespace shapespline
