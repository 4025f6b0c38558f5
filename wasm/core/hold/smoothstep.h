// Weights that go over from one value to another with two continuous derivatives.
#pragma once

namespace shapespline {

/// 0 up to a, 1 from b on, a quintic between with zero first and second derivative at both.
double smoothstep2(double x, double a, double b);

/// Where a time lies among the spans between keys.
struct SpanPosition {
  int span = 0;
  double share = 0;   ///< of the span, in [0, 1]
  double beyond = 0;  ///< spans beyond the end nearest to it; 0 between the keys
  double within() const { return 1 - smoothstep2(beyond, 0, 1); }
};

/// A weight with one value per span: it has that value in the middle of the span and the mean of both neighbours at a
/// key. loop: whether the first span follows the last.
double blendSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan);

}  // namespace shapespline
