// How patches turn when a shape is pulled, and what turns them further: a limb bends then instead of shearing.
#pragma once

#include <vector>

#include "core/hold/affine_response.h"
#include "core/hold/hold_passes.h"

namespace shapespline {

/// One step of as-rigid-as-possible deformation (Sorkine and Alexa 2007) with a rotation per patch instead of one per
/// vertex, over-relaxed. Immutable.
class ArapRotation {
 public:
  /// modes: of what pulls; patches that these hardly turn are left as they are.
  ArapRotation(const HoldInput& input, const AffineResponse& modes);

  /// The further rotation of each patch, minus the identity, in the frame of its present rotation. frames: of the shape
  /// before the pull; mode: of the pull.
  void find(const AffineResponse& modes, const std::vector<Vec3>& mode, const std::vector<Quaternion>& frames,
            std::vector<Mat3>& turn) const;

  /// Adds what pulls each vertex so that its patches turn.
  void addTo(Positions& pulls, const std::vector<Mat3>& turn) const { addPulls(pulls_, turn, pulls); }

 private:
  std::vector<int> patchOfFrame_;
  std::vector<double> frameShare_;  // in its patch
  std::vector<PatchPull> pulls_;    // what holds a vertex in its patch in the reference pose; by vertex
};

}  // namespace shapespline
