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
  /// The keys of `shape` on `curve`, in the world of its first period. The curve must be cubic.
  VertexPath(const WeldedShape& shape, const Curve& curve);

  /// Each key seen from its own frame: rotation[key]^T (vertex - origin[key]). Nothing rests.
  VertexPath(const WeldedShape& shape, const Curve& curve, const std::vector<Mat3>& rotation,
             const std::vector<Vec3>& origin);

  VertexPath(VertexPath&&) = default;
  VertexPath& operator=(VertexPath&&) = default;

  int spans() const { return static_cast<int>(spans_.size()); }
  bool loop() const { return loop_; }
  SpanPlace placeOf(double t) const;

  /// How little a vertex moves in a span beside the spans before and after it, in [0, 1]. Speeds are compared, so that
  /// neither size nor unit of time matter.
  float rest(int span, std::size_t v) const { return rest_[span][v]; }

  /// What all vertices share at one time.
  struct At {
    const Positions *from, *to;
    const std::vector<float>*startSlope, *endSlope, *startRest, *endRest;
    // Of the step and the slopes at both ends; of the parts of them that rest takes away at either end.
    double step = 0, slope0 = 0, slope1 = 0, rest0[3] = {}, rest1[3] = {};
  };
  At at(double t) const;

  /// The quintic that has the spline's position at both keys, and there its velocity and acceleration scaled down by
  /// the rest around the key. Without rest the cubic.
  static Vec3 position(const At& at, std::size_t v) {
    const Vec3& p = (*at.from)[v];
    const Vec3 step = (*at.to)[v] - p;
    const float *a = &(*at.startSlope)[3 * v], *b = &(*at.endSlope)[3 * v];
    const Vec3 slope0(a[0], a[1], a[2]), slope1(b[0], b[1], b[2]);
    const double r0 = at.startRest->empty() ? 0 : (*at.startRest)[v], r1 = at.endRest->empty() ? 0 : (*at.endRest)[v];
    return p + (at.step - r0 * at.rest0[0] - r1 * at.rest1[0]) * step +
           (at.slope0 - r0 * at.rest0[1] - r1 * at.rest1[1]) * slope0 +
           (at.slope1 - r0 * at.rest0[2] - r1 * at.rest1[2]) * slope1;
  }

 private:
  void findRest(double diagonal);

  std::vector<KeySpan> spans_;
  bool loop_ = false;
  std::vector<Positions> own_;                        // those that are no poses of the shape
  std::vector<const Positions*> knots_;               // spans + 1
  std::vector<std::vector<float>> slope_, knotRest_;  // of each knot
  std::vector<std::vector<float>> rest_;              // of each span
};

}  // namespace shapespline
