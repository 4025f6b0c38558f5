// Own paths: faces that rotate as they do by themselves, faded towards LRI space where the two disagree.
#pragma once

#include <variant>
#include <vector>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// What own paths are taken against.
enum class OwnPaths {
  Off,
  Absolute,  ///< nothing: nearer to sampled animations; a key that is turned as a whole changes the motion
  Root,      ///< the largest frame: a key that is turned as a whole changes nothing
};

/// With q = R_own R_lri^T, R_f = exp(2 q.w |q.w|^4 q.vec) R_lri: all of the own path where both agree, nothing of it at
/// half a turn. An own path goes from key to key as RotationSplines do; of the increments that differ by whole turns it
/// takes the one that comes nearest to LRI space's rotations on the way. Immutable.
class OwnPathsSpace {
 public:
  /// Both must outlive the space. The faces must have coordinates of their own: not with Transfer::Paper.
  OwnPathsSpace(const WeldedKeys& keys, const LriSpace& lri, OwnPaths base);

  /// frames: of LRI space at `point`. Real: of LRI space's reconstructor. own: scratch space.
  template <class Real>
  void rotationsAt(const CurvePoint& point, const LocalFrames& frames, const Reconstructor<Real>& reconstructor,
                   typename Reconstructor<Real>::Scratch& scratch, RotationBlocks<Real>& own,
                   RotationBlocks<Real>& rotations, ForkJoin* forkJoin = nullptr) const;

 private:
  Quaternion baseAt(const CurvePoint& point, const LocalFrames& frames) const;

  const WeldedKeys* keys_;
  OwnPaths base_;
  int root_ = 0;  // frame
  std::variant<RotationPaths<float>, RotationPaths<double>> paths_;
};

}  // namespace shapespline
