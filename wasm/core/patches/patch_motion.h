// The patches of a shape as local frames: rotations from the connection maps (the first system of paper section 4.2),
// aligned with the rotation of the whole in the keys.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/lri/local_frames.h"
#include "core/patches/global_alignment.h"
#include "core/patches/patch_coordinates.h"
#include "core/patches/patch_rotations.h"
#include "core/rotation/turn_choice.h"

namespace shapespline {

/// Full turns added before keys: to all patches in each step, and to the components attached by bridges.
struct PatchTurns {
  std::vector<double> whole;
  std::vector<WholeTurns> bridges;
};

/// Immutable.
class PatchMotion {
 public:
  struct Scratch {
    std::vector<Quaternion> connection, path;
    PatchRotationSystem::Scratch turn;
  };

  /// Factors the first system for an open curve and for a loop. Error: the solver's.
  static Result<PatchMotion> create(const WeldedShape& shape, PatchCoordinates coordinates);

  /// A turn's component refers to a component of the given shape. An empty list gives no turns.
  PatchTurns addedTurns(const WeldedShape& shape, const std::vector<AddedTurns>& turns) const;

  /// The local frames at `point`. At a key, they equal the encoded ones. Patches in parts with timings of their own
  /// advance along their own paths from the mean of the parts. The added turns of components keep the mean.
  void at(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const;

  /// Advances the patches of each part of `point` from the frames at the mean to the part. scratch: as at() left it.
  void advanceParts(const CurvePoint& point, const PatchTurns& turns, const Scratch& scratch,
                    LocalFrames& frames) const;

  /// Angles at a point without parts, in radians.
  struct Disagreement {
    std::vector<double> ofPatch;  ///< between each patch's rotation and its own path
    double ofLinks = 0;           ///< the largest between a link's rotation and its own; 0 if links form a tree
  };
  Disagreement disagreement(const CurvePoint& point) const;

  /// How far each patch rotates past its keys at a point of an open curve, in radians: the sum of its increments, each
  /// times the part of its share outside 0 to 1.
  std::vector<double> overshoot(const CurvePoint& point) const;

  const PatchCoordinates& coordinates() const { return patches_; }
  LocalFramePoses poses() const { return {patches_.patches.ofFace, patches_.rotation}; }

  /// Rotation of the whole in a step between two keys, radians: the mean over the patches.
  double wholeTurn(int step) const { return worldTurn(step).norm(); }
  /// Whether the keys leave the direction of this rotation ambiguous.
  bool isWholeTurnOpen(int step) const { return isOpen_[step] != 0; }

 private:
  // One solver for the steps of an open curve, one for those of a loop with its closing interval.
  struct Solver {
    PatchRotationSystem system;
    GlobalAlignment alignment;
  };
  PatchMotion(const WeldedShape& shape, PatchCoordinates coordinates);
  std::vector<int> stepsOf(const WeldedShape& shape, bool loop) const;
  Result<Solver> makeSolver(const std::vector<int>& steps) const;
  using FractionRotations = std::array<std::vector<Quaternion>, 3>;
  struct OwnTurns {
    std::vector<Vec3> first, other;  // increments of all patches
    TurnOptions options;
  };
  void solveAtFraction(const Solver& solver, int step, double share, std::vector<Quaternion>& rotation) const;
  void turnAtFraction(const Solver& solver, int step, double share, const Vec3& rootTurn,
                      std::vector<Quaternion>& rotation) const;
  std::vector<Vec3> ownIncrements(const Solver& solver, int step, const FractionRotations& atFraction,
                                  bool flipped) const;
  OwnTurns ownTurns(const Solver& solver, int step) const;
  void take(int step, const OwnTurns& turns, bool other);
  void findOwnPaths(const std::vector<int>& open);
  void closeOwnPaths();
  GlobalAlignment makeAlignment(const Solver& solver, const std::vector<int>& steps) const;
  std::vector<double> evennessWeights(bool isLoop) const;
  void findAxes();
  Vec3 worldTurn(int step) const;
  Vec3 meanTurn(int step, const std::vector<Vec3>& increment) const;
  Vec3 turnAxis(const WeldedShape& shape, int step, std::size_t bridge) const;
  Quaternion addedTurn(const CurvePoint& point, const PatchTurns& turns) const;
  Quaternion turnOfPeriods(const CurvePoint& point) const;

  KeySteps steps_;
  std::vector<StepPoses> posesOf_;      // at both ends of each step
  std::optional<RigidMotion> closing_;  // for a loop whose last key repeats the first
  PatchCoordinates patches_;
  RotationSplines own_;  // separate rotation path of each patch
  std::optional<Solver> open_, loop_;
  std::vector<char> isOpen_;  // per step
  std::vector<Vec3> axis_;    // per step, world axis at its first key
};

}  // namespace shapespline
