// Deformation transfer from a ghost mesh (paper section 4.3; Sumner and Popovic 2004). The splines run on the ghost,
// and its faces provide the local frames of the full-resolution faces.
#pragma once

#include <memory>
#include <vector>

#include "core/ghost/correspondence.h"
#include "core/ghost/simplify.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"

namespace shapespline {

/// A moving ghost mesh as a source of local frames: the frame of face f is ghost face c = c(f).
///
/// Exact: D_f(t) = R_c(t) exp(r_f(t)) S_f(t). R_c is the rotation of the ghost face's deformation gradient in the
/// ghost's coordinates. r_f and S_f are splined with the same weights: each key's rotation relative to the ghost,
/// log(R_c^T R_f), and the face's stretch. Omitting the ghost's stretch keeps S_f symmetric in the face's tangent frame
/// (three numbers) and equal to its value without a ghost, and no thin ghost face is ever inverted. The splined R_c is
/// as accurate as the rotation of the ghost's solved vertices (KG error 0.029 and 0.033 on a cactus with 2,000 ghost
/// faces), and it is defined where the ghost folds.
/// Paper: D_f(t) = Q_c(t), the whole gradient relative to the reference, including stretch.
///
/// The ghost is small, so it is always computed in double. Immutable.
class GhostMotion {
 public:
  /// Options for making and following the ghost.
  struct Options {
    int faces = 0;                  ///< requested number
    bool optimalPlacement = false;  ///< see simplify.h
    int patches = 0;                ///< requested number for the ghost; 0 = default
    Stretch stretch = Stretch::Linear;
    Transfer transfer = Transfer::Exact;
  };
  struct Scratch {
    PatchMotion::Scratch patches;
    LocalFrames frames;  // frames of the ghost's patches
    Reconstructor<double>::Scratch shape;
    Positions positions;
  };
  /// Wall times, ms: collapses; the ghost's coordinates and systems; correspondence.
  struct Times {
    double simplify = 0, encode = 0, match = 0;
  };

  /// Simplifies the shape, encodes the ghost and factors its systems. Error: a solver's.
  static Result<GhostMotion> create(const WeldedShape& shape, const ShapeTopology& topology, const Options& options,
                                    const StageProgress& progress);

  /// The rotations of the ghost's faces at `point`, and their gradients for the paper's transfer.
  void at(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const;

  /// The ghost's vertices at `point`.
  void positions(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, Positions& positions) const;

  /// The ghost's frames in the encoded poses.
  LocalFramePoses poses() const { return {faceOf_, rotation_}; }

  const GhostMesh& mesh() const { return mesh_; }
  const WeldedShape& shape() const { return *shape_; }
  const std::vector<int>& correspondence() const { return faceOf_; }  ///< c(f); -1 for a face without area
  const PatchMotion& patches() const { return patches_; }
  const LriCoordinates<double>& coordinates() const { return reconstructor_.coordinates(); }
  const Times& times() const { return times_; }

 private:
  GhostMotion(const Options& options, GhostMesh mesh, std::unique_ptr<const WeldedShape> shape, PatchMotion patches,
              Reconstructor<double> reconstructor);
  Mat3 gradient(int face, const Mat3& rotation, const Positions& positions) const;

  Transfer transfer_;
  GhostMesh mesh_;
  std::unique_ptr<const WeldedShape> shape_;  // faces and poses of the ghost
  PatchMotion patches_;
  Reconstructor<double> reconstructor_;
  std::vector<int> faceOf_;
  std::vector<std::vector<Quaternion>> rotation_;  // rotation_[column][ghost face]
  Times times_;
};

}  // namespace shapespline
