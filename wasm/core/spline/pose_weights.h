// Maps the weights of a curve's columns to the encoded poses.
#pragma once

#include <limits>
#include <vector>

#include "core/base/types.h"
#include "core/spline/pose_roles.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Weights closer to zero than this do not change a sum of numbers of type Real. A cubic spline's weights fall by a
/// factor of about 0.27 from key to key, so all omitted weights sum to less than three times the largest. The numbers
/// (logarithms of rotations, stretches) rarely exceed ten. The error therefore stays below half a rounding step.
template <class Real>
inline constexpr double minWeight = std::numeric_limits<Real>::epsilon() / 64;

/// Weights of the encoded poses.
struct PoseWeights {
  std::vector<double> column;  ///< one per column of the coordinates
  int keys = 0;                ///< number of leading columns that are keys
  int beyond = -1;             ///< end key from which the curve continues beyond the keys, or -1 within them
};

/// Weights too small for any sum in double precision are 0.
PoseWeights poseWeights(const CurvePoint& point, const PoseRoles& roles);

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights);

}  // namespace shapespline
