// A motion whose pins are held: the shape is pulled to where they are wanted, its patches turn along, and it is pulled
// once more. A fixed number of solves with one factored system: as smooth in time as what pulls.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/hold/patch_turn.h"
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

  struct Scratch {
    Positions target, body, pulled, way;
    std::vector<double> vector;
    PatchTurn::Scratch turn;
    HoldSystem::Scratch solve;
  };

  /// Corrects a shape: positions of the welded vertices, in the world of the first period. t: within that, if there is
  /// one. frames: those of the shape, `mean` what the mean of its vertices follows.
  void apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape, Scratch& scratch,
             ForkJoin* forkJoin) const;

  /// Welded vertices of a pin, ascending. One that several pins would hold belongs to the first.
  std::vector<int> verticesOf(int pin) const;

 private:
  /// One vertex that is held.
  struct Held {
    int vertex, pin;
    double weight;
    bool operator==(const Held&) const = default;
  };

  /// A key whose place is kept. In a loop that ends elsewhere what stays goes with it, evenly.
  struct Stay {
    const Positions* pose = nullptr;
    double time = 0;
  };

  PinnedMotion(const HoldInput& input, const Curve& curve, std::vector<Held> held, const std::vector<Pin>& pins);
  RigidMotion wayOf(const Stay& stay, double t) const;
  static std::vector<Held> heldVertices(const HoldInput& input, const std::vector<Pin>& pins,
                                        const std::vector<int>& weldedOf);
  void findWay(double t, const SpanPlace& place, const std::vector<Quaternion>& frames, const Vec3& mean,
               const Positions& shape, Scratch& scratch) const;
  void scatterPull(Scratch& scratch) const;

  std::vector<Held> held_;
  std::vector<int> vertices_;
  KeyTurns turns_;
  RestTarget target_;
  std::vector<Stay> stays_;  // of each pin; without a pose it follows its own splines
  std::optional<RigidMotion> closing_;
  double period_;
  std::vector<std::unique_ptr<const PinPath>> path_;
  std::shared_ptr<const PatchTurn> patches_;
  std::shared_ptr<const HoldSystem> system_;
};

}  // namespace shapespline
