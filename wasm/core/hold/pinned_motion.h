// A motion with pins. Rotations of patches are predicted from the pins' target positions, then the shape is pulled to
// these positions. Takes one solve per time with a factored system, and is as smooth as the pull.
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
  /// weldedOf: welded vertex of each input vertex. before: motion of the same shape whose system is reused if it has
  /// the same pinned vertices, or null. The curve must be cubic. At least one pin, checked by checkPins. Error: the
  /// solver's.
  static Result<std::shared_ptr<const PinnedMotion>> create(const HoldInput& input, const Curve& curve,
                                                            const std::vector<Pin>& pins,
                                                            const std::vector<int>& weldedOf,
                                                            const PinnedMotion* before);

  /// Whether both motions share a system, so nothing was factored.
  bool sharesSystem(const PinnedMotion* other) const { return other && other->pull_ == pull_; }

  struct Scratch {
    Positions target, body, displacement, pulls;
    std::vector<Vec3> mode;
    std::vector<Mat3> turn;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: positions of the welded vertices, in the coordinates of the first period. t: within the first
  /// period of a loop. frames: local frames of the shape. mean: target of the mean vertex position.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

  /// Welded vertices of a pin, ascending. A vertex in several pins belongs to the first.
  std::vector<int> verticesOf(int pin) const;

 private:
  /// Data that depends only on the set of held vertices.
  struct Pull {
    HoldSystem system;
    AffineResponse modes;
    ArapRotation patches;
  };

  /// A key whose position is kept. In a loop that does not close in place, the position drifts evenly with the loop.
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
  std::vector<Stay> stays_;  // one per pin; without a pose, the pin follows its own splines
  std::optional<RigidMotion> closing_;
  double period_;
  std::vector<std::unique_ptr<const PinPath>> path_;
  std::shared_ptr<const Pull> pull_;
};

}  // namespace shapespline
