#include "core/rotation/rigid_fit.h"

#include <algorithm>

#include "core/base/centroid.h"
#include "core/rotation/rotation.h"

namespace shapespline {

RigidFit fitRigid(const Positions& from, const Positions& to) {
  const Vec3 a = centroidOf(from), b = centroidOf(to);
  Mat3 covariance = Mat3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) covariance += (to[v] - b) * (from[v] - a).transpose();
  RigidFit fit{projectToRotation(covariance), 0};
  for (std::size_t v = 0; v < from.size(); ++v)
    fit.largestDistance = std::max(fit.largestDistance, (fit.rotation * (from[v] - a) - (to[v] - b)).norm());
  return fit;
}

}  // namespace shapespline
