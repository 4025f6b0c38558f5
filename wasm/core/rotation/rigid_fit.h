// The rigid motion that takes one set of points nearest to another.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// The rotation and the largest distance that remain when `from` is moved rigidly onto `to` (least squares, Kabsch).
struct RigidFit {
  Mat3 rotation;
  double largestDistance = 0;
};
RigidFit fitRigid(const Positions& from, const Positions& to);

}  // namespace shapespline
