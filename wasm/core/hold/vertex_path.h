// The keys' vertices, each on a cubic spline of its own that does not overshoot where the vertex rests.
#pragma once

#include <vector>

#include "core/hold/fade.h"
#include "core/lri/welded_shape.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Positions at the ends of the spans of a curve, and how a vertex passes them.
class VertexPath {
 public:
  /// The keys of `shape` on `curve`, in the world of its first period. The curve must be cubic, and the shape outlive
  /// the path. rests: whether what rests does not overshoot.
  VertexPath(const WeldedShape& shape, const Curve& curve, bool rests);

  VertexPath(const VertexPath&) = delete;
  VertexPath& operator=(const VertexPath&) = delete;

  int spans() const { return static_cast<int>(spans_.size()); }
  bool loop() const { return loop_; }
  SpanPlace placeOf(double t) const;

  /// How little a vertex moves in a span beside the spans before and after it, in [0, 1]. Speeds are compared, so that
  /// neither size nor unit of time matter.
  float rest(int span, std::size_t v) const { return rest_[span][v]; }

  /// What all vertices share at one time.
  struct At {
    std::size_t span = 0;
    // Of the step and the slopes at both ends; of the parts of them that rest takes away at either end.
    double step = 0, slope0 = 0, slope1 = 0, rest0[3] = {}, rest1[3] = {};
  };
  At at(double t) const;

  /// The quintic that has the spline's position at both keys, and there its velocity and acceleration scaled down by
  /// the rest around the key. Without rest the cubic.
  Vec3 position(const At& at, std::size_t v) const;

 private:
  void findRest(double diagonal);

  std::vector<KeySpan> spans_;
  bool loop_ = false;
  Positions closed_;                                  // the last key of a loop that ends elsewhere
  std::vector<const Positions*> knots_;               // spans + 1
  std::vector<std::vector<float>> slope_, knotRest_;  // of each knot
  std::vector<std::vector<float>> rest_;              // of each span
};

}  // namespace shapespline
