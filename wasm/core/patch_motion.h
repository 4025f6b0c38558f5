// The patches of a shape as frames: their rotations from the connection maps (the first system of paper section 4.2),
// components hung on their anchors, the whole turned to where the keys have it.
#pragma once

#include <vector>

#include "core/alignment.h"
#include "core/frame_source.h"
#include "core/patch_coordinates.h"
#include "core/patch_rotations.h"
#include "core/pose_weights.h"

namespace shapespline {

class PatchMotion final : public FrameSource {
 public:
  /// Factorises the first system. The shape must outlive this object.
  Status build(const WeldedShape& shape, PatchCoordinates coordinates, int rootPatch);

  void at(const Weights& weights, Frames& frames) override;

  /// Patch rotations at `weights`, up to one common rotation. Components hang on their anchors.
  void unaligned(const Weights& weights, std::vector<Quaternion>& rotation);

  const PatchCoordinates& coordinates() const { return patches_; }
  FramePoses poses() const { return {patches_.patches.ofFace, patches_.rotation}; }
  Alignment& alignment() { return alignment_; }
  const Alignment& alignment() const { return alignment_; }

 private:
  void hangComponents(const PoseWeights& weights, std::vector<Quaternion>& rotation) const;

  const WeldedShape* shape_ = nullptr;
  PatchCoordinates patches_;
  PatchRotationSystem system_;
  Alignment alignment_;
  std::vector<std::vector<int>> patchesOf_;  // patches of each piece
  std::vector<Vec3> pair_;                   // scratch
};

}  // namespace shapespline
