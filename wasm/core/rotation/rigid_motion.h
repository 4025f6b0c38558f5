// A rotation and a shift together, and its powers: a walk that goes on, a loop that closes somewhere else.
#pragma once

#include "core/rotation/rotation.h"

namespace shapespline {

/// p -> rotation p + translation.
struct RigidMotion {
  Quaternion rotation = Quaternion::Identity();
  Vec3 translation = Vec3::Zero();

  Vec3 operator()(const Vec3& p) const { return rotation * p + translation; }

  /// The motion done s times, for any real s: exp(s log M) on SE(3), a screw whose rotation is the principal one.
  RigidMotion power(double s) const;
};

}  // namespace shapespline
