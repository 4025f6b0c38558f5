// Shapes of a motion at any time: what holds the scratch space. One per thread.
#pragma once

#include <vector>

#include "core/base/fork_join.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/motion.h"

namespace shapespline {

/// One shape of the sequence, in the input's own vertices.
struct Frame {
  std::vector<float> positions;  ///< 3n, xyz interleaved
  std::vector<float> normals;    ///< 3n, unit, xyz interleaved
  int indefiniteFaces = 0;       ///< faces whose interpolated S_f is not positive definite
  int indefiniteFace = -1;       ///< one of them, of the input; -1 where there is none
};

/// Every result is a pure function of its arguments, bit for bit. Times must be finite. encoded: what the motion was
/// fitted to.
class Evaluator {
 public:
  /// Frames are made by two from here on, to the same bits, or by one with null. It must outlive the evaluator.
  void setForkJoin(ForkJoin* forkJoin) { forkJoin_ = forkJoin; }

  /// The shape at time t, which may lie beyond the keys.
  void frame(const EncodedShape& encoded, const Motion& motion, double t, Frame& frame);

  /// The same as n positions in double. As exact as the encoding's precision.
  void positions(const EncodedShape& encoded, const Motion& motion, double t, Positions& positions);

  /// One position per welded vertex at a point of the motion's curve, before anything is held and the whole is moved.
  void unmoved(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point, Positions& positions);

  /// The shape at an affine combination of the keys, one weight per key.
  void blend(const EncodedShape& encoded, const Motion& motion, const std::vector<double>& weights, Frame& frame);

  /// xyz of each vertex of the ghost at time t; LRI space and a ghost must have been made.
  void ghost(const EncodedShape& encoded, const Motion& motion, double t, std::vector<float>& positions);

  /// The rotations G_k of the patches of LRI space at time t, as the first system gives them and the whole is turned.
  void patchRotations(const EncodedShape& encoded, const Motion& motion, double t, std::vector<Quaternion>& rotations);

  /// What was counted and timed here: solves and the last frame's times.
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

  // What shapes are reconstructed in, in either precision.
  template <class Real>
  struct Solved {
    typename Reconstructor<Real>::Scratch scratch;
    RotationBlocks<Real> rotations, own;  // where faces rotate by themselves
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
