// The keys' vertices, each on a cubic spline of its own that does not overshoot where the vertex rests.
#pragma once

#include <vector>

#include "core/hold/smoothstep.h"
#include "core/lri/welded_shape.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Where a path does not overshoot.
struct PathRest {
  enum { Nowhere, WhereStill, AtEnds } where = Nowhere;
  double size = 1;  ///< of the whole shape (keySize); a vertex that moves by a small share of this is still
};

/// Of the largest key, whichever way it is turned.
double keySize(const WeldedShape& shape);

/// Positions at the ends of the spans of a curve, and how a vertex passes them.
class RestingSpline {
 public:
  /// The keys of `shape` on `curve`, in the world of its first period. The curve must be cubic, and the shape outlive
  /// the path. With PathRest::AtEnds an open path stands still beyond its ends.
  RestingSpline(const WeldedShape& shape, const Curve& curve, const PathRest& rest);

  RestingSpline(const RestingSpline&) = delete;
  RestingSpline& operator=(const RestingSpline&) = delete;

  int spans() const { return static_cast<int>(spans_.size()); }
  bool loop() const { return loop_; }
  SpanPosition spanPositionAt(double t) const;
  /// Whether it runs through the same keys at the same times: of the same shape, the same vertices rest then.
  bool hasSpansOf(const RestingSpline& other) const;

  /// How little a vertex moves in a span beside the spans before and after it, in [0, 1], and not only turns around.
  /// Speeds are compared, so neither size nor unit of time matter.
  float rest(int span, std::size_t v) const { return rest_[span][v]; }

  /// All vertices at time t: the quintic that has the spline's position at both keys, and there its velocity and
  /// acceleration scaled down by the rest around the key. Without rest the cubic.
  void positionsAt(double t, Positions& positions) const;

 private:
  void findRest(double size);
  double turnsBack(std::size_t v, int before, int after, double slowest) const;

  std::vector<KeySpan> spans_;
  bool loop_ = false;
  Positions closed_;                                  // the last key of a loop that ends elsewhere
  std::vector<const Positions*> knots_;               // spans + 1
  std::vector<std::vector<float>> slope_, knotRest_;  // of each knot
  std::vector<std::vector<float>> rest_;              // of each span
};

}  // namespace shapespline
