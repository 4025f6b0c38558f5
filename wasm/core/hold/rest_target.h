// Target positions of vertices. Each vertex follows its own spline, without overshoot while it rests. Nearly rigid
// motions follow the spline of the rigid motion.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/hold/hold_input.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// Rotations between keys, for the whole (or some faces) and for the frames.
struct KeyRotations {
  /// groupOf: rigid group of each vertex; empty for the whole.
  KeyRotations(const HoldInput& input, const Curve& curve, const std::vector<int>& groupOf = {}, int group = 0);

  /// Area-weighted sum of the frames. Its nearest rotation is their mean rotation.
  Mat3 sumOf(const std::vector<Quaternion>& frames) const;

  std::vector<double> frameArea;
  std::vector<Mat3> whole;        ///< mean rotation of each column
  std::vector<double> wholeTurn;  ///< angle of the whole in each span
  std::vector<double> frameTurn;  ///< rms angle of each frame between keys
  double area = 0;                ///< area of all frames; 1 for the whole
  double deforms = 1;             ///< 0 if the motion is nearly rigid
};

/// Targets of all vertices, or of some. Immutable.
class RestTarget {
 public:
  /// Vertices that move as one rigid body. A single group covers the whole shape.
  struct RigidGroup {
    KeyRotations turns;
    std::vector<int> vertices;  ///< in the order of the target
    // Poses relative to the group's frame, for nearly rigid motions.
    WeldedShape shape = {};
    std::optional<RestingSpline> path = {};
  };

  /// only: welded vertices of a single rigid group, or null for all vertices. The curve must be cubic. The input must
  /// outlive the target.
  RestTarget(const HoldInput& input, const Curve& curve, const std::vector<int>* only = nullptr);

  RestTarget(const RestTarget&) = delete;
  RestTarget& operator=(const RestTarget&) = delete;

  const RestingSpline& path() const { return *path_; }
  const std::vector<std::unique_ptr<RigidGroup>>& rigidGroups() const { return rigidGroups_; }

  /// frames: at t. mean: target of the mean vertex position.
  void at(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& target,
          Positions& scratch) const;

 private:
  WeldedShape some_;  // set if `only` is given
  std::optional<RestingSpline> path_;
  std::vector<std::unique_ptr<RigidGroup>> rigidGroups_;
};

}  // namespace shapespline
