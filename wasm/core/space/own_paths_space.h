// Own paths: separate rotation paths of faces, blended with LRI space where the two disagree.
#pragma once

#include <variant>
#include <vector>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// Base frame of the own paths.
enum class OwnPaths {
  Off,
  Absolute,  ///< none: closer to sampled animations; rotating a whole key changes the motion
  Root,      ///< the largest local frame: rotating a whole key has no effect
};

/// With q = R_own R_lri^T, R_f = exp(2 q.w |q.w|^4 q.vec) R_lri. R_f is the own path where both agree, and LRI space's
/// at half a turn. Own paths are RotationSplines between the keys. Among increments that differ by full turns, the one
/// nearest to LRI space's rotations along the step is chosen. Immutable.
class OwnPathsSpace {
 public:
  /// Both must outlive the space. Requires separate coordinates of the faces, so not with Transfer::Paper.
  OwnPathsSpace(const WeldedKeys& keys, const LriSpace& lri, OwnPaths base);

  /// frames: LRI space's at `point`. Real: the type of LRI space's reconstructor. own: scratch memory.
  template <class Real>
  void rotationsAt(const CurvePoint& point, const LocalFrames& frames, const Reconstructor<Real>& reconstructor,
                   typename Reconstructor<Real>::Scratch& scratch, RotationBlocks<Real>& own,
                   RotationBlocks<Real>& rotations, ForkJoin* forkJoin = nullptr) const;

 private:
  Quaternion baseAt(const CurvePoint& point, const LocalFrames& frames) const;

  const WeldedKeys* keys_;
  OwnPaths base_;
  int root_ = 0;  // index of the base frame
  std::variant<RotationPaths<float>, RotationPaths<double>> paths_;
};

}  // namespace shapespline
