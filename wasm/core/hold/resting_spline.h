// Cubic splines of the vertices through the keys, without overshoot where a vertex rests.
#pragma once

#include <vector>

#include "core/hold/smoothstep.h"
#include "core/lri/welded_shape.h"
#include "core/spline/spline.h"

namespace shapespline {

/// The keys at which a path must not overshoot.
struct PathRest {
  enum { Nowhere, WhereStill, AtEnds } where = Nowhere;
  double size = 1;  ///< size of the whole shape (keySize); a motion by a small share of it counts as rest
};

/// Size of the largest key, independent of orientation.
double keySize(const WeldedShape& shape);

/// Positions at the ends of a curve's spans, and the slope and rest of each vertex there.
class RestingSpline {
 public:
  /// Uses the keys of `shape` on `curve`, in the coordinates of the first period. The curve must be cubic, and the
  /// shape must outlive the path. With PathRest::AtEnds, an open path is constant beyond its ends.
  RestingSpline(const WeldedShape& shape, const Curve& curve, const PathRest& rest);

  RestingSpline(const RestingSpline&) = delete;
  RestingSpline& operator=(const RestingSpline&) = delete;

  int spans() const { return static_cast<int>(spans_.size()); }
  bool loop() const { return loop_; }
  SpanPosition spanPositionAt(double t) const;
  /// Whether both paths have the same keys at the same times. If they belong to one shape, the same vertices rest in
  /// both.
  bool hasSpansOf(const RestingSpline& other) const;

  /// How little a vertex moves in a span relative to the neighbouring spans, in [0, 1]; 0 for a vertex that only
  /// reverses. Compares speeds, so size and time unit do not matter.
  float rest(int span, std::size_t v) const { return rest_[span][v]; }

  /// Positions of all vertices at time t: the quintic with the spline's positions at both keys, and its velocity and
  /// acceleration reduced by the rest around each key. Without rest, it equals the cubic.
  void positionsAt(double t, Positions& positions) const;

 private:
  void findRest(double size);
  double turnsBack(std::size_t v, int before, int after, double slowest) const;

  std::vector<KeySpan> spans_;
  bool loop_ = false;
  Positions closed_;                                  // last key of a loop that does not close in place
  std::vector<const Positions*> knots_;               // spans + 1
  std::vector<std::vector<float>> slope_, knotRest_;  // per knot
  std::vector<std::vector<float>> rest_;              // per span
};

}  // namespace shapespline
