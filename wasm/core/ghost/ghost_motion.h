// Deformation transfer from a ghost mesh (paper section 4.3; Sumner and Popovic 2004): the splines run on the ghost, and its
// faces give the frames in which the full-resolution faces stand.
#pragma once

#include <vector>

#include "core/ghost/correspondence.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"
#include "core/sequence/sequence_stats.h"
#include "core/ghost/simplify.h"

namespace shapespline {

/// A ghost mesh in motion, as a source of frames: face f stands in the frame of ghost face c = c(f).
///
/// Exact: D_f(t) = R_c(t) exp(r_f(t)) S_f(t), where R_c is the rotation of the ghost face's deformation gradient as the ghost's
/// coordinates give it, and r_f and S_f are splined with the same weights: what each key shows beyond the ghost's
/// rotation, log(R_c^T R_f), and the face's own stretch. Leaving the ghost's stretch out keeps S_f symmetric in the face's
/// tangent frame (three numbers) and what it is without a ghost; no thin ghost face is ever inverted. Taking the
/// splined R_c, not that of the ghost's solved vertices, costs nothing (KG 0.029 and 0.033 on a cactus with 2,000
/// ghost faces) and is defined where the ghost folds.
/// Paper: D_f(t) = Q_c(t), the whole gradient against the reference, stretch included.
///
/// The ghost is small: it is always computed in double.
class GhostMotion final : public FrameSource {
 public:
  /// Simplifies the shape, encodes the ghost and factorises its systems. The shape may go afterwards.
  Status build(const WeldedShape& shape, const ShapeParts& parts, const EncodingOptions& options, SequenceStats& stats,
               const StageProgress& progress);

  void at(const CurvePoint& point, Frames& frames) override;

  /// The ghost's vertices at `point`; returns its number of faces whose S_f is not positive definite.
  int positions(const CurvePoint& point, Positions& positions);

  /// The ghost's frames in the poses that were encoded.
  FramePoses poses() const { return {faceOf_, rotation_}; }

  const GhostMesh& mesh() const { return mesh_; }
  const WeldedShape& shape() const { return shape_; }
  const std::vector<int>& correspondence() const { return faceOf_; }  ///< c(f); -1 where a face has no area
  PatchMotion& patchMotion() { return patches_; }
  const PatchMotion& patchMotion() const { return patches_; }
  const LriCoordinates<double>& coordinates() const { return reconstructor_.coordinates(); }

 private:
  Status buildMotion(const EncodingOptions& options, int wantedPatches, SequenceStats& stats);
  Mat3 gradient(int face, const Mat3& rotation) const;

  Transfer transfer_ = Transfer::Exact;
  GhostMesh mesh_;
  WeldedShape shape_;  // the ghost's own faces and poses
  PatchMotion patches_;
  Reconstructor<double> reconstructor_;
  std::vector<int> faceOf_;
  std::vector<std::vector<Quaternion>> rotation_;  // rotation_[column][ghost face]
  Positions positions_;                            // scratch
};

}  // namespace shapespline
