// Keeps parts still that rest between keys. The shape is fitted rigidly to target positions, barely rotating patches
// are pulled to them, and resting patches are held. Every correction is a weight times the difference of two curves
// that agree at the keys. The keys therefore stay exact, and the motion stays as smooth as before.
#pragma once

#include <memory>
#include <vector>

#include "core/hold/contact_constraints.h"
#include "core/hold/hold_passes.h"
#include "core/hold/rest_target.h"
#include "core/hold/turned_spans.h"

namespace shapespline {

/// Immutable.
class HeldMotion {
 public:
  /// turns: added full turns. before: an earlier motion of the same shape, or null. Its system and handles are reused
  /// if this motion needs the same. The curve must be cubic. Error: the solver's.
  static Result<std::shared_ptr<const HeldMotion>> create(const HoldInput& input, const Curve& curve,
                                                          const std::vector<AddedTurns>& turns,
                                                          const HeldMotion* before);

  /// Whether both motions share a system, so nothing was factored.
  bool sharesSystem(const HeldMotion* other) const { return other && other->system_ == system_; }

  /// Share of holding in each interval between keys; empty without added turns.
  const std::vector<double>& heldShare() const { return heldShare_; }

  struct Scratch {
    Positions target, body, pulls;
    std::vector<double> weight;
    std::vector<Vec3> pull;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: positions of the welded vertices, in the coordinates of the first period. t: within the first
  /// period of a loop. frames: local frames of the shape. mean: target of the mean vertex position.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

 private:
  HeldMotion(const HoldInput& input, const Curve& curve, const std::vector<AddedTurns>& turns);
  void findResting(const HoldInput& input);
  std::vector<double> anchorWeights(const HoldMesh& mesh) const;
  void moveOntoTarget(const SpanPosition& inSpan, const std::vector<Quaternion>& frames, const Vec3& mean,
                      const Positions& target, Positions& shape) const;
  void holdPatches(bool together, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const;

  RestTarget target_;
  std::vector<double> area_;                 // area of each vertex
  std::vector<std::vector<double>> placed_;  // for each rigid group, weight of the fit in each span
  std::vector<double> heldShare_;
  std::vector<double> anchor_;  // penalty weight of each vertex
  std::shared_ptr<const HoldSystem> system_;
  std::shared_ptr<const ContactConstraints> resting_;
};

}  // namespace shapespline
