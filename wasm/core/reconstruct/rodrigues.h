// Exponential of rotation vectors in lanes, by Rodrigues' formula.
#pragma once

#include <cmath>
#include <type_traits>

#include "core/base/simd.h"
#include "core/lri/face_coordinates.h"
#include "core/rotation/rotation_series.h"

namespace shapespline {

// Ranges of the two series in x, the squared angle; seriesLimit is slightly more than half a turn. The first omitted
// term is below the precision's rounding there. Larger angles use the C library. Most faces rotate by less than half a
// radian in their frames and need few terms.
inline constexpr double seriesLimit = 10.5, shortLimit = 0.25;
template <class Real>
inline constexpr int seriesTerms = std::is_same_v<Real, float> ? 11 : 17;
template <class Real>
inline constexpr int shortTerms = std::is_same_v<Real, float> ? 4 : 8;

// The two factors of Rodrigues' formula exp(r) = I + a [r] + b [r]^2.
template <class Real>
struct Rodrigues {
  Lanes<Real> a, b;
};

template <class Real>
Rodrigues<Real> rodriguesOfLargeAngles(Lanes<Real> squaredAngle) {
  using L = Lanes<Real>;
  alignas(32) Real x[faceLanes], a[faceLanes], b[faceLanes];
  squaredAngle.store(x);
  horner<seriesTerms<Real>>(rotationSeries.sine, squaredAngle).store(a);
  horner<seriesTerms<Real>>(rotationSeries.cosine, squaredAngle).store(b);
  for (int i = 0; i < faceLanes; ++i) {
    if (x[i] <= Real(seriesLimit)) continue;
    const double angle = std::sqrt(static_cast<double>(x[i]));
    a[i] = static_cast<Real>(std::sin(angle) / angle);
    b[i] = static_cast<Real>((1 - std::cos(angle)) / (angle * angle));
  }
  return {L::load(a), L::load(b)};
}

template <class Real>
Rodrigues<Real> rodrigues(Lanes<Real> squaredAngle) {
  using L = Lanes<Real>;
  if (!notPositive(L::splat(Real(shortLimit)) - squaredAngle))
    return {horner<shortTerms<Real>>(rotationSeries.sine, squaredAngle),
            horner<shortTerms<Real>>(rotationSeries.cosine, squaredAngle)};
  if (!notPositive(L::splat(Real(seriesLimit)) - squaredAngle))
    return {horner<seriesTerms<Real>>(rotationSeries.sine, squaredAngle),
            horner<seriesTerms<Real>>(rotationSeries.cosine, squaredAngle)};
  return rodriguesOfLargeAngles<Real>(squaredAngle);
}

}  // namespace shapespline
