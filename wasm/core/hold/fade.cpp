#include "core/hold/fade.h"

#include <algorithm>

namespace shapespline {

double fade(double x, double a, double b) {
  const double u = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

double tween(const double* value, int spans, bool loop, const SpanPlace& place) {
  const auto at = [&](int span) { return value[loop ? (span + spans) % spans : std::clamp(span, 0, spans - 1)]; };
  const double own = at(place.span), start = (at(place.span - 1) + own) / 2, end = (own + at(place.span + 1)) / 2;
  return start + (own - start) * fade(place.share, 0, 0.5) + (end - own) * fade(place.share, 0.5, 1);
}

}  // namespace shapespline
