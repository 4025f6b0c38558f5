// A motion with pins: the rotations of patches are predicted from the wanted positions of the pins, then the shape is
// pulled there. One solve per time with a factored system, as smooth as the pull itself.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/hold/arap_rotation.h"
#include "core/hold/pin_path.h"
#include "core/hold/rest_target.h"

namespace shapespline {

/// Immutable.
class PinnedMotion {
 public:
  /// weldedOf: of each vertex of the input. before: of the same shape, whose system is taken over where the same is
  /// pinned; or null. The curve must be cubic and the pins checked, at least one. Error: that of the solver.
  static Result<std::shared_ptr<const PinnedMotion>> create(const HoldInput& input, const Curve& curve,
                                                            const std::vector<Pin>& pins,
                                                            const std::vector<int>& weldedOf,
                                                            const PinnedMotion* before);

  /// Whether the other's system was taken over, so nothing was factored.
  bool sharesSystem(const PinnedMotion* other) const { return other && other->pull_ == pull_; }

  struct Scratch {
    Positions target, body, displacement, pulls;
    std::vector<Vec3> mode;
    std::vector<Mat3> turn;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: positions of the welded vertices, in the world of the first period. t: within that, if there is
  /// one. frames: those of the shape, `mean` what the mean of its vertices follows.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

  /// Welded vertices of a pin, ascending. One that several pins would hold belongs to the first.
  std::vector<int> verticesOf(int pin) const;

 private:
  /// What depends on which vertices are held alone.
  struct Pull {
    HoldSystem system;
    AffineResponse modes;
    ArapRotation patches;
  };

  /// A key whose place is kept. In a loop that ends elsewhere what stays goes with it, evenly.
  struct Stay {
    const Positions* pose = nullptr;
    double time = 0;
  };

  PinnedMotion(const HoldInput& input, const Curve& curve, std::vector<HeldVertex> held, const std::vector<Pin>& pins);
  RigidMotion motionOfPin(const Stay& stay, double t) const;
  static std::vector<HeldVertex> heldVertices(const HoldInput& input, const std::vector<Pin>& pins,
                                              const std::vector<int>& weldedOf);
  void findDisplacement(double t, const SpanPosition& inSpan, const std::vector<Quaternion>& frames, const Vec3& mean,
                        const Positions& shape, Scratch& scratch) const;

  std::vector<HeldVertex> held_;
  std::vector<int> vertices_;
  RestTarget target_;
  std::vector<Stay> stays_;  // of each pin; without a pose it follows its own splines
  std::optional<RigidMotion> closing_;
  double period_;
  std::vector<std::unique_ptr<const PinPath>> path_;
  std::shared_ptr<const Pull> pull_;
};

}  // namespace shapespline
