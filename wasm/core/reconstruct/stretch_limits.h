// How far stretch may go beyond the keys, and how it eases towards that. Between the keys nothing is limited.
#pragma once

#include <cmath>

namespace shapespline {

/// Beyond the keys a face's stretches stay between its least of all keys over this factor and its largest times it.
inline constexpr double stretchMargin = 1.5;

/// What a change is scaled by that would reach a limit when it is 1/u of itself: (1 + u^4)^(-1/4). u times that goes to
/// 1 and starts as u - u^5 / 4: a curve that goes on straight eases off without a step in its first four derivatives.
/// Roots and quotients alone, each of which rounds once in every build. Number: double, or Lanes (core/base/simd.h).
inline double easing(double u) { return 1 / std::sqrt(std::sqrt(1 + u * u * (u * u))); }
template <class Lanes>
Lanes easing(Lanes u) {
  const Lanes one = Lanes::splat(1), squared = u * u;
  return one / squareRoot(squareRoot(one + squared * squared));
}

}  // namespace shapespline
