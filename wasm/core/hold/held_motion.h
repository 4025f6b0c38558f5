// Keeps what rests between the keys where it is: the shape is placed by what its vertices do, what hardly turns is
// drawn to its vertices' paths, and resting patches are held. Every correction is a weight times the difference of two
// curves that agree at the keys, so the keys stay exact and the motion as smooth as it was.
#pragma once

#include <memory>
#include <vector>

#include "core/hold/contact_constraints.h"
#include "core/hold/hold_passes.h"
#include "core/hold/rest_target.h"

namespace shapespline {

/// Immutable.
class HeldMotion {
 public:
  /// before: of the same shape, whose system and handles are taken over where they are the same; or null. The curve
  /// must be cubic. Error: that of the solver.
  static Result<std::shared_ptr<const HeldMotion>> create(const HoldInput& input, const Curve& curve,
                                                          const HeldMotion* before);

  /// Whether the other's system was taken over, so nothing was factored.
  bool sharesSystem(const HeldMotion* other) const { return other && other->system_ == system_; }

  struct Scratch {
    Positions target, body, pulls;
    std::vector<double> weight;
    std::vector<Vec3> pull;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: the positions of the welded vertices, in the world of the first period. t: within that, if
  /// there is one. frames: those of the shape, `mean` what the mean of its vertices follows.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

 private:
  HeldMotion(const HoldInput& input, const Curve& curve);
  void findResting(const HoldInput& input);
  std::vector<double> anchorWeights(const HoldMesh& mesh) const;
  void moveOntoTarget(const SpanPosition& inSpan, const std::vector<Quaternion>& frames, const Vec3& mean,
                      const Positions& target, Positions& shape) const;
  void holdPatches(bool together, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const;

  RestTarget target_;
  std::vector<double> area_;                 // of each vertex
  std::vector<std::vector<double>> placed_;  // of each body, share of each span
  std::vector<double> anchor_;               // of each vertex
  std::shared_ptr<const HoldSystem> system_;
  std::shared_ptr<const ContactConstraints> resting_;
};

}  // namespace shapespline
