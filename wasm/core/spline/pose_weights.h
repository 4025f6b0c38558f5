// The weights of a curve's columns, taken to the poses that were encoded.
#pragma once

#include <limits>
#include <vector>

#include "core/base/types.h"
#include "core/spline/pose_roles.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Weights closer to zero than this change no sum of numbers of type Real. A cubic spline's weights fall by a factor of
/// about 0.27 from key to key: all that are left out together come to less than three times the largest, and the
/// numbers (logarithms of rotations, stretches) are hardly above ten, so what is missing stays below half a rounding
/// step.
template <class Real>
inline constexpr double leastWeight = std::numeric_limits<Real>::epsilon() / 64;

/// Weights over the poses that were encoded.
struct PoseWeights {
  std::vector<double> column;  ///< one per column of the coordinates
  int keys = 0;                ///< the first columns, which are keys
  int beyond = -1;             ///< end key that the curve goes on from beyond the keys, or -1 within them
};

/// Weights that no sum in double precision can show are 0.
PoseWeights poseWeights(const CurvePoint& point, const PoseRoles& roles);

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights);

}  // namespace shapespline
