// Deformation transfer from a ghost mesh (paper section 4.3; Sumner and Popovic 2004): the splines run on the ghost,
// and its faces give the frames in which the full-resolution faces stand.
#pragma once

#include <memory>
#include <vector>

#include "core/ghost/correspondence.h"
#include "core/ghost/simplify.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"

namespace shapespline {

/// A ghost mesh in motion, as a source of frames: face f stands in the frame of ghost face c = c(f).
///
/// Exact: D_f(t) = R_c(t) exp(r_f(t)) S_f(t), where R_c is the rotation of the ghost face's deformation gradient as the
/// ghost's coordinates give it, and r_f and S_f are splined with the same weights: what each key shows beyond the
/// ghost's rotation, log(R_c^T R_f), and the face's own stretch. Leaving the ghost's stretch out keeps S_f symmetric in
/// the face's tangent frame (three numbers) and what it is without a ghost; no thin ghost face is ever inverted. Taking
/// the splined R_c, not that of the ghost's solved vertices, costs nothing (KG 0.029 and 0.033 on a cactus with 2,000
/// ghost faces) and is defined where the ghost folds.
/// Paper: D_f(t) = Q_c(t), the whole gradient against the reference, stretch included.
///
/// The ghost is small: it is always computed in double. Immutable.
class GhostMotion {
 public:
  /// How the ghost is made and followed.
  struct Options {
    int faces = 0;                  ///< wanted
    bool optimalPlacement = false;  ///< simplify.h
    int patches = 0;                ///< wanted, of the ghost; 0 = default
    Stretch stretch = Stretch::Linear;
    Transfer transfer = Transfer::Exact;
  };
  struct Scratch {
    PatchMotion::Scratch patches;
    LocalFrames frames;  // of the ghost's patches
    Reconstructor<double>::Scratch shape;
    Positions positions;
  };
  /// Wall times, ms: collapses; the ghost's own coordinates and systems; which face follows which.
  struct Times {
    double simplify = 0, encode = 0, match = 0;
  };

  /// Simplifies the shape, encodes the ghost and factors its systems. Error: that of a solver.
  static Result<GhostMotion> create(const WeldedShape& shape, const ShapeTopology& topology, const Options& options,
                                    const StageProgress& progress);

  /// The rotations of the ghost's faces at `point`, and their gradients where the paper's transfer asks for them.
  void at(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const;

  /// The ghost's vertices at `point`.
  void positions(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, Positions& positions) const;

  /// The ghost's frames in the poses that were encoded.
  LocalFramePoses poses() const { return {faceOf_, rotation_}; }

  const GhostMesh& mesh() const { return mesh_; }
  const WeldedShape& shape() const { return *shape_; }
  const std::vector<int>& correspondence() const { return faceOf_; }  ///< c(f); -1 where a face has no area
  const PatchMotion& patches() const { return patches_; }
  const LriCoordinates<double>& coordinates() const { return reconstructor_.coordinates(); }
  const Times& times() const { return times_; }

 private:
  GhostMotion(const Options& options, GhostMesh mesh, std::unique_ptr<const WeldedShape> shape, PatchMotion patches,
              Reconstructor<double> reconstructor);
  Mat3 gradient(int face, const Mat3& rotation, const Positions& positions) const;

  Transfer transfer_;
  GhostMesh mesh_;
  std::unique_ptr<const WeldedShape> shape_;  // the ghost's own faces and poses
  PatchMotion patches_;
  Reconstructor<double> reconstructor_;
  std::vector<int> faceOf_;
  std::vector<std::vector<Quaternion>> rotation_;  // rotation_[column][ghost face]
  Times times_;
};

}  // namespace shapespline
