// Limits of stretch beyond the keys, and easing towards them. Between the keys, stretch is not limited.
#pragma once

#include <cmath>

namespace shapespline {

/// Beyond the keys, the stretches of a face are limited. Lower limit: its smallest stretch over all keys, divided by
/// this factor. Upper limit, for logarithmic stretch only: its largest stretch, times this factor.
inline constexpr double stretchMargin = 1.5;

/// Scale of a change that would reach its limit at 1/u of itself: (1 + u^4)^(-1/4). u times this scale tends to 1 and
/// starts as u - u^5 / 4, so a straight curve eases without a step in its first four derivatives. Uses only roots and
/// quotients, each of which rounds once in every build. Number: double, or Lanes (core/base/simd.h).
inline double easing(double u) { return 1 / std::sqrt(std::sqrt(1 + u * u * (u * u))); }
template <class Lanes>
Lanes easing(Lanes u) {
  const Lanes one = Lanes::splat(1), squared = u * u;
  return one / squareRoot(squareRoot(one + squared * squared));
}

}  // namespace shapespline
