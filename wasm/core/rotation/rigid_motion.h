// SE(3): rigid motions and their powers.
#pragma once

#include "core/rotation/rotation.h"

namespace shapespline {

/// p -> rotation p + translation.
struct RigidMotion {
  Quaternion rotation = Quaternion::Identity();
  Vec3 translation = Vec3::Zero();

  Vec3 operator()(const Vec3& p) const { return rotation * p + translation; }

  /// The motion applied s times, for any real s: exp(s log M) on SE(3), a screw with the principal rotation.
  RigidMotion power(double s) const;
};

}  // namespace shapespline
