// Evaluates shapes of a motion at any time. Owns the scratch memory. One per thread.
#pragma once

#include <vector>

#include "core/base/fork_join.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/motion.h"

namespace shapespline {

/// One shape of the sequence, in the input's vertices.
struct Frame {
  std::vector<float> positions;  ///< 3n, xyz interleaved
  std::vector<float> normals;    ///< 3n, unit, xyz interleaved
  int indefiniteFaces = 0;       ///< faces whose interpolated S_f is not positive definite
  int indefiniteFace = -1;       ///< one such input face, or -1
};

/// Every result is a pure function of its arguments, bit for bit. Times must be finite. encoded: the shape of the
/// motion.
class Evaluator {
 public:
  /// Computes frames on two threads, or on one if forkJoin is null. Results are bitwise equal. forkJoin must outlive
  /// the evaluator.
  void setForkJoin(ForkJoin* forkJoin) { forkJoin_ = forkJoin; }

  /// The shape at time t, including times beyond the keys.
  void frame(const EncodedShape& encoded, const Motion& motion, double t, Frame& frame);

  /// The shape as n positions in double, with the accuracy of the encoding's precision.
  void positions(const EncodedShape& encoded, const Motion& motion, double t, Positions& positions);

  /// One position per welded vertex at a point of the motion's curve, before holding and before moving the whole.
  void unmoved(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point, Positions& positions);

  /// The shape at an affine combination of the keys, one weight per key.
  void blend(const EncodedShape& encoded, const Motion& motion, const std::vector<double>& weights, Frame& frame);

  /// xyz of each ghost vertex at time t. LRI space with a ghost must exist.
  void ghost(const EncodedShape& encoded, const Motion& motion, double t, std::vector<float>& positions);

  /// The rotations G_k of LRI space's patches at time t, after rotating the whole.
  void patchRotations(const EncodedShape& encoded, const Motion& motion, double t, std::vector<Quaternion>& rotations);

  /// Counters and times: solves, and the parts of the last frame.
  const FrameStats& stats() const { return stats_; }

 private:
  Reconstruction reconstruct(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point,
                             PaddedShape<float>& padded, ForkJoin* forkJoin);
  Reconstruction blendKeys(const EncodedShape& encoded, const CurvePoint& point, PaddedShape<float>& padded);
  void hold(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point);
  void holdShape(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point,
                 PaddedShape<float>& padded);
  void moveGhost(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point);
  void reconstruct(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point, Frame& frame);
  void draw(const EncodedShape& encoded, const Motion& motion, const RigidMotion& global, Frame& frame);
  template <class Real>
  Reconstruction solve(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point,
                       const Reconstructor<Real>& reconstructor, PaddedShape<Real>& padded, ForkJoin* forkJoin);

  // Scratch memory for reconstruction, in either precision.
  template <class Real>
  struct Solved {
    typename Reconstructor<Real>::Scratch scratch;
    RotationBlocks<Real> rotations;  // for methods with separate face rotations
    PaddedShape<Real> padded;
  };
  Solved<float>& solved(const Reconstructor<float>&) { return single_; }
  Solved<double>& solved(const Reconstructor<double>&) { return double_; }

  ForkJoin* forkJoin_ = nullptr;
  FrameStats stats_;
  LriSpace::Scratch framesScratch_;
  RimdSpace::Scratch rimdScratch_;
  LocalFrames frames_;
  Solved<float> single_;
  Solved<double> double_;
  HeldMotion::Scratch heldScratch_;
  PinnedMotion::Scratch pinnedScratch_;
  VertexNormals::Scratch normalsScratch_;
  PaddedShape<float> padded_;
  Positions welded_;
};

}  // namespace shapespline
