// Where vertices would be by themselves: each on its own spline, without overshoot where it rests, and on that of a
// rigid body where the whole moves like one.
#pragma once

#include <optional>
#include <vector>

#include "core/hold/hold_input.h"
#include "core/hold/vertex_path.h"

namespace shapespline {

/// How the whole and its frames turn from key to key.
struct KeyTurns {
  KeyTurns(const HoldInput& input, const Curve& curve);

  /// What the mean rotation of frames is the nearest rotation to: their sum by area.
  Mat3 sumOf(const std::vector<Quaternion>& frames) const;

  std::vector<double> frameArea;
  std::vector<Mat3> whole;        ///< mean rotation of each column
  std::vector<double> wholeTurn;  ///< angle of the whole in each span
  std::vector<double> frameTurn;  ///< rms angle of each frame from key to key
  double deforms = 1;             ///< 0 where the motion is nearly a rigid body's
};

/// Of all vertices, or of some. Immutable.
class RestTarget {
 public:
  /// only: welded vertices, or null for all. The curve must be cubic, and the input outlive the target.
  RestTarget(const HoldInput& input, const Curve& curve, const KeyTurns& turns, const std::vector<int>* only = nullptr);

  RestTarget(const RestTarget&) = delete;
  RestTarget& operator=(const RestTarget&) = delete;

  const VertexPath& path() const { return *path_; }

  /// turn, mean: the mean rotation of the frames at t, and what the mean of all vertices follows.
  void at(double t, const Mat3& turn, const Vec3& mean, Positions& target, Positions& body) const;

 private:
  WeldedShape some_;  // with `only`
  std::optional<VertexPath> path_;
  // In the frame of the whole, where the motion is nearly that of a rigid body.
  WeldedShape body_;
  std::optional<VertexPath> rigid_;
  double deforms_;
};

}  // namespace shapespline
