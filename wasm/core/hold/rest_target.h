// Where vertices would be by themselves: each on its own spline, without overshoot where it rests, and on that of a
// rigid body where the whole moves like one.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/hold/hold_input.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// How the whole, or some of its faces, and the frames turn from key to key.
struct KeyTurns {
  /// bodyOf: of each vertex; empty for the whole.
  KeyTurns(const HoldInput& input, const Curve& curve, const std::vector<int>& bodyOf = {}, int body = 0);

  /// What the mean rotation of frames is the nearest rotation to: their sum by area.
  Mat3 sumOf(const std::vector<Quaternion>& frames) const;

  std::vector<double> frameArea;
  std::vector<Mat3> whole;        ///< mean rotation of each column
  std::vector<double> wholeTurn;  ///< angle of the whole in each span
  std::vector<double> frameTurn;  ///< rms angle of each frame from key to key
  double area = 0;                ///< of all frames; of the whole 1
  double deforms = 1;             ///< 0 where the motion is nearly a rigid body's
};

/// Of all vertices, or of some. Immutable.
class RestTarget {
 public:
  /// What moves as one. Alone it is the whole.
  struct RigidGroup {
    KeyTurns turns;
    std::vector<int> vertices;  ///< in the order of the target
    // Seen from the body, where the motion is nearly a rigid body's.
    WeldedShape shape = {};
    std::optional<RestingSpline> path = {};
  };

  /// only: welded vertices, all of one body, or null for all vertices. The curve must be cubic, and the input outlive
  /// the target.
  RestTarget(const HoldInput& input, const Curve& curve, const std::vector<int>* only = nullptr);

  RestTarget(const RestTarget&) = delete;
  RestTarget& operator=(const RestTarget&) = delete;

  const RestingSpline& path() const { return *path_; }
  const std::vector<std::unique_ptr<RigidGroup>>& rigidGroups() const { return rigidGroups_; }

  /// frames: at t; mean: what the mean of all vertices follows.
  void at(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& target,
          Positions& scratch) const;

 private:
  WeldedShape some_;  // with `only`
  std::optional<RestingSpline> path_;
  std::vector<std::unique_ptr<RigidGroup>> rigidGroups_;
};

}  // namespace shapespline
