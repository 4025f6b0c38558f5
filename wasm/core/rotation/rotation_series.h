// Power series of sin(a) / a and (1 - cos(a)) / a^2 in x = a^2, for one number or for lanes.
#pragma once

#include <type_traits>

namespace shapespline {

struct RotationSeries {
  static constexpr int maxTerms = 17;
  double sine[maxTerms], cosine[maxTerms];
};

constexpr RotationSeries makeRotationSeries() {
  RotationSeries s{};
  double factorial = 1;  // (2k + 1)!
  for (int k = 0; k < RotationSeries::maxTerms; ++k) {
    const double sign = k % 2 == 0 ? 1 : -1;
    if (k > 0) factorial *= (2.0 * k) * (2.0 * k + 1);
    s.sine[k] = sign / factorial;
    s.cosine[k] = sign / (factorial * (2.0 * k + 2));
  }
  return s;
}

inline constexpr RotationSeries rotationSeries = makeRotationSeries();

/// The sum of coefficient[k] x^k for k < terms. Number: a floating-point type, or Lanes (core/base/simd.h).
template <int terms, int k = 0, class Number>
Number horner(const double (&coefficient)[RotationSeries::maxTerms], Number x) {
  Number term;
  if constexpr (std::is_floating_point_v<Number>) term = static_cast<Number>(coefficient[k]);
  else term = Number::splat(static_cast<typename Number::Real>(coefficient[k]));
  if constexpr (k + 1 == terms) return term;
  else return horner<terms, k + 1>(coefficient, x) * x + term;
}

}  // namespace shapespline
