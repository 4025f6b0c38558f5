#pragma once

#include <limits>

namespace shapespline {

/// How the numbers that a frame streams through are stored. They are always computed in double.
enum class Precision {
  Single,  ///< what is drawn: 1e-5 of the bounding box
  Double,
  Exact,   ///< coordinates in double, the factor in single: the solution is refined until it is the double one's equal
};

/// Weights closer to zero than this change no sum of numbers of type Real. A cubic spline's weights fall by a factor of about 0.27 from key
/// to key: all that are left out together come to less than three times the largest, and the numbers (logarithms of rotations,
/// stretches) are hardly above ten, so that what is missing stays below half a rounding step.
template <class Real>
inline constexpr double leastWeight = std::numeric_limits<Real>::epsilon() / 64;

}  // namespace shapespline
