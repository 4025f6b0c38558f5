// Extra rotations of patches in a pulled shape, so a limb bends instead of shearing.
#pragma once

#include <vector>

#include "core/hold/affine_response.h"
#include "core/hold/hold_passes.h"

namespace shapespline {

/// One step of as-rigid-as-possible deformation (Sorkine and Alexa 2007) with a rotation per patch instead of one per
/// vertex, over-relaxed. Immutable.
class ArapRotation {
 public:
  /// modes: response to the pulls. Patches that barely rotate are ignored.
  ArapRotation(const HoldInput& input, const AffineResponse& modes);

  /// The extra rotation of each patch minus the identity, in the patch's current frame. frames: local frames of the
  /// shape before the pull. mode: modes of the pull.
  void find(const AffineResponse& modes, const std::vector<Vec3>& mode, const std::vector<Quaternion>& frames,
            std::vector<Mat3>& turn) const;

  /// Adds the pulls on vertices that rotate their patches.
  void addTo(Positions& pulls, const std::vector<Mat3>& turn) const { addPulls(pulls_, turn, pulls); }

 private:
  std::vector<int> patchOfFrame_;
  std::vector<double> frameShare_;  // share in its patch
  std::vector<PatchPull> pulls_;  // ARAP forces of each vertex in its patches, in the reference pose; sorted by vertex
};

}  // namespace shapespline
