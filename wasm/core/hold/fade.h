// Weights that go over from one value to another with two continuous derivatives.
#pragma once

#include <algorithm>
#include <vector>

namespace shapespline {

/// 0 up to a, 1 from b on, a quintic between with zero first and second derivative at both.
inline double fade(double x, double a, double b) {
  const double u = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

/// Where a time lies among the spans between keys.
struct SpanPlace {
  int span = 0;
  double share = 0;   ///< of the span, in [0, 1]
  double beyond = 0;  ///< spans beyond the end nearest to it; 0 between the keys
  double within() const { return 1 - fade(beyond, 0, 1); }
};

/// A weight with one value per span: it has that value in the middle of the span and the mean of both neighbours at a
/// key. loop: whether the first span follows the last.
template <class ValueOf>
double tween(const ValueOf& value, int spans, bool loop, const SpanPlace& place) {
  const auto at = [&](int span) { return value(loop ? (span + spans) % spans : std::clamp(span, 0, spans - 1)); };
  const double own = at(place.span), start = (at(place.span - 1) + own) / 2, end = (own + at(place.span + 1)) / 2;
  return start + (own - start) * fade(place.share, 0, 0.5) + (end - own) * fade(place.share, 0.5, 1);
}

}  // namespace shapespline
