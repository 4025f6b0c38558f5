// Keeps what rests between the keys where it is: the shape is placed by what its vertices do, and resting patches are
// held. Every correction is a weight times the difference of two curves that agree at the keys, so that the keys stay
// exact and the motion as smooth as it was.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/hold/hold_passes.h"
#include "core/hold/resting_patches.h"

namespace shapespline {

/// What the motion is corrected by.
enum class Hold {
  Off,       ///< nothing: the paper's method
  Contact,   ///< the shape is the method's, placed by its vertices; resting patches are held
  Anchored,  ///< further, what hardly turns is drawn to its vertices' paths
};

/// Of the shape that is held. All of it must outlive what is made of it.
struct HoldInput {
  HoldMesh mesh;
  const std::vector<int>& patchOfFace;                   ///< -1 without area
  const std::vector<std::vector<Quaternion>>& rotation;  ///< rotation[column][frame]
  const std::vector<Vec3>& meanPosition;                 ///< one per column
  Precision precision;
};

/// Immutable.
class HeldMotion {
 public:
  /// before: of the same shape, whose system and handles are taken over where they are the same; or null. The curve
  /// must be cubic and hold not Off. Error: that of the solver.
  static Result<std::shared_ptr<const HeldMotion>> create(const HoldInput& input, const Curve& curve, Hold hold,
                                                          const HeldMotion* before);

  struct Scratch {
    Positions target, body;
    std::vector<double> vector, weight;
    std::vector<Vec3> pull;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: the positions of the welded vertices, in the world of the first period. t: within that, if
  /// there is one. frames: those of the shape, `mean` what the mean of its vertices follows.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

 private:
  struct Placement {
    Mat3 turn;
    Vec3 move;
  };

  HeldMotion(const HoldInput& input, const Curve& curve, Hold hold);
  void findResting(const HoldInput& input);
  void measureTurns(const HoldInput& input, const std::vector<KeySpan>& spans, const std::vector<Mat3>& poses);
  void findBody(const HoldInput& input, const Curve& curve, const std::vector<Mat3>& poses);
  std::vector<double> anchorWeights(const HoldInput& input, const std::vector<double>& faceArea) const;
  double placementShare(const SpanPlace& place, const Mat3& frameSum, const Mat3& mean) const;
  Mat3 frameSum(const std::vector<Quaternion>& frames) const;
  Placement place(const FitSums& sums, double share) const;
  void anchor(double share, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const;
  void holdPatches(Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const;

  Hold hold_;
  VertexPath path_;
  // In the frame of the whole, where the motion is nearly that of a rigid body.
  WeldedShape body_;
  std::optional<VertexPath> rigid_;
  double deforms_ = 1;        // 0 where it is
  std::vector<double> area_;  // of each vertex
  std::vector<double> frameArea_;
  std::vector<double> placed_;     // share of each span
  std::vector<double> anchor_;     // of each vertex; with Hold::Anchored
  std::vector<double> frameTurn_;  // rms angle of each frame from key to key
  std::shared_ptr<const HoldSystem> system_;
  std::shared_ptr<const RestingPatches> resting_;
};

}  // namespace shapespline
