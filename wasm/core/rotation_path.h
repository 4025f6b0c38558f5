// A rotation that moves through the keys: the cumulative form on SO(3) (Kim, Kim and Shin 1995). A body may turn far and
// often, which a splined rotation vector cannot say.
#pragma once

#include <vector>

#include "core/rotation.h"
#include "core/spline.h"

namespace shapespline {

/// R(t) = R_1 prod_i exp(C_i(t) w_i), w_i = log(R_{i-1}^T R_i) and C_i the curve through 0 before key i and 1 from key i
/// on: the sum of the weights from key i on. Exact at the keys, as smooth as the weights, any number of turns, and for two
/// keys the geodesic. End tangents turn the ends: their columns weigh log(R_1^T R_start) and log(R_J^T R_end).
class RotationPath {
 public:
  RotationPath() = default;

  /// rotations: one a key, at least one. The increments are principal; an increment of nearly half a turn goes the way of
  /// the one before it.
  explicit RotationPath(std::vector<Quaternion> rotations);

  /// Sets an increment that is another representative of the same rotation. increment: 1 to J - 1, or J for the closing
  /// one from the last key to the first.
  void setIncrement(int increment, const Vec3& rotationVector) { increments_[increment] = rotationVector; }
  const Vec3& increment(int increment) const { return increments_[increment]; }

  void setTangents(const Quaternion* start, const Quaternion* end);

  Quaternion at(const Weights& weights) const;

  const Quaternion& key(int key) const { return rotations_[key]; }
  int keyCount() const { return static_cast<int>(rotations_.size()); }

 private:
  std::vector<Quaternion> rotations_;
  std::vector<Vec3> increments_;  // [0] is unused, [J] closes
  Vec3 startTangent_ = Vec3::Zero(), endTangent_ = Vec3::Zero();
};

}  // namespace shapespline
