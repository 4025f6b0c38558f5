// Evaluates rotation splines (rotation_spline.h), four at a time.
#pragma once

#include <span>
#include <vector>

#include "core/base/fork_join.h"
#include "core/reconstruct/rotation_blocks.h"
#include "core/spline/rotation_spline.h"

namespace shapespline {

/// Immutable.
template <class Real>
class RotationPaths {
 public:
  RotationPaths() = default;
  /// slotOf: slot of each path. Slots without a path rest.
  RotationPaths(const RotationSplines& paths, KeySteps steps, std::span<const int> slotOf);

  /// The rotations at `point`, each followed by the rotation `whole`.
  void at(const CurvePoint& point, const Quaternion& whole, RotationBlocks<Real>& rotations,
          ForkJoin* forkJoin = nullptr) const;

  Vec3 increment(int step, int slot) const;

 private:
  void blocksAt(const CurvePoint& point, const Quaternion& whole, std::size_t begin, std::size_t end,
                Real* rotations) const;

  bool isTangent(int step) const { return step == steps_.startTangent() || step == steps_.endTangent(); }

  KeySteps steps_{};
  std::size_t blocks_ = 0;
  std::vector<RotationBlocks<Real>> key_;     // rotations of each column
  std::vector<std::vector<Real>> increment_;  // increments of each step: [block][x, y, z][lane]
};

}  // namespace shapespline
