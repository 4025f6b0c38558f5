#include "core/hold/smoothstep.h"

#include <algorithm>

namespace shapespline {

double smoothstep2(double x, double a, double b) {
  const double u = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

double blendSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan) {
  const auto at = [&](int span) { return value[loop ? (span + spans) % spans : std::clamp(span, 0, spans - 1)]; };
  const double own = at(inSpan.span), start = (at(inSpan.span - 1) + own) / 2, end = (own + at(inSpan.span + 1)) / 2;
  return start + (own - start) * smoothstep2(inSpan.share, 0, 0.5) + (end - own) * smoothstep2(inSpan.share, 0.5, 1);
}

}  // namespace shapespline
