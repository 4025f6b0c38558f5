#include "core/hold/smoothstep.h"

#include <algorithm>

namespace shapespline {

double smoothstep2(double x, double a, double b) {
  const double u = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

namespace {

// atKey: the value at a key from those of both spans.
template <class AtKey>
double blended(const double* value, int spans, bool loop, const SpanPosition& inSpan, const AtKey& atKey) {
  const auto at = [&](int span) { return value[loop ? (span + spans) % spans : std::clamp(span, 0, spans - 1)]; };
  const double own = at(inSpan.span), start = atKey(at(inSpan.span - 1), own), end = atKey(own, at(inSpan.span + 1));
  return start + (own - start) * smoothstep2(inSpan.share, 0, 0.5) + (end - own) * smoothstep2(inSpan.share, 0.5, 1);
}

}  // namespace

double blendSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan) {
  return blended(value, spans, loop, inSpan, [](double a, double b) { return (a + b) / 2; });
}

double lesserOfSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan) {
  return blended(value, spans, loop, inSpan, [](double a, double b) { return std::min(a, b); });
}

}  // namespace shapespline
