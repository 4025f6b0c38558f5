// The patches of a shape as frames: their rotations from the connection maps (the first system of paper section 4.2), the whole turned
// to where the keys have it.
#pragma once

#include <vector>

#include "core/patches/global_alignment.h"
#include "core/lri/frame_source.h"
#include "core/sequence/options.h"
#include "core/patches/patch_coordinates.h"
#include "core/patches/patch_rotations.h"

namespace shapespline {

class PatchMotion final : public FrameSource {
 public:
  PatchMotion() = default;
  PatchMotion(const PatchMotion&) = delete;  // its systems hold on to its graph
  PatchMotion& operator=(const PatchMotion&) = delete;

  /// Factorises the first system. The shape must outlive this object.
  Status build(const WeldedShape& shape, PatchCoordinates coordinates);

  void at(const CurvePoint& point, Frames& frames) override;

  /// Adds whole turns on the way to keys; replaces those set before. A turn's component is a component of the shape here.
  void setTurns(const std::vector<AddedTurns>& turns);

  const PatchCoordinates& coordinates() const { return patches_; }
  FramePoses poses() const { return {patches_.patches.ofFace, patches_.rotation}; }

  /// How far the whole turns in a step between two keys, radians: the mean over the patches.
  double wholeTurn(int step) const { return worldTurn(step).norm(); }

 private:
  // One for the steps of an open curve, one for those of a loop with its closing interval.
  struct Solver {
    PatchRotationSystem system;
    Alignment alignment;
  };
  std::vector<int> stepsOf(bool loop) const;
  Status buildSystem(Solver& solver, const std::vector<int>& steps);
  void buildAlignment(Solver& solver, const std::vector<int>& steps);
  void partWay(Solver& solver, int step, double share, std::vector<Quaternion>& rotation);
  void findOwnIncrements(Solver& solver, int step);
  Vec3 worldTurn(int step) const;
  Vec3 turnAxis(int step, std::size_t bridge) const;
  Quaternion addedTurn(const CurvePoint& point) const;

  const WeldedShape* shape_ = nullptr;
  PatchCoordinates patches_;
  RotationPaths own_;                // the rotation of each patch by itself
  Solver open_, loop_;
  std::vector<double> turns_;        // added to the whole in each step
  std::vector<Vec3> axis_;           // of each step, world, at the key where it begins
  std::vector<Quaternion> connection_, path_;       // scratch
};

}  // namespace shapespline
