// C2 weights: transitions between values with two continuous derivatives.
#pragma once

namespace shapespline {

/// 0 up to a, 1 from b on. The quintic between has zero first and second derivative at both ends.
double smoothstep2(double x, double a, double b);

/// Position of a time in the spans between keys.
struct SpanPosition {
  int span = 0;
  double share = 0;   ///< position in the span, in [0, 1]
  double beyond = 0;  ///< distance beyond the nearest end in spans; 0 between the keys
  double held = 1;    ///< share of holding between the keys
  double within() const { return held * (1 - smoothstep2(beyond, 0, 1)); }
};

/// A C2 weight from one value per span: the span's value in its middle, and the mean of both neighbours at a key. loop:
/// whether the first span follows the last.
double blendSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan);

/// The same, with the lesser of both neighbours at a key.
double lesserOfSpans(const double* value, int spans, bool loop, const SpanPosition& inSpan);

}  // namespace shapespline
