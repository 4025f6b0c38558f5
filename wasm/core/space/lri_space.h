// LRI space of a shape: its patches or its ghost, the coordinates of its poses and the factored systems.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/base/warning.h"
#include "core/ghost/ghost_motion.h"
#include "core/hold/hold_input.h"
#include "core/mesh/vertex_normals.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"
#include "core/space/gram_matrix.h"
#include "core/space/welded_keys.h"

namespace shapespline {

/// Choices that change the coordinates.
struct LriOptions {
  int patches =
      0;  ///< wanted number of patches (of the ghost, with one), 0 = the default formula (patches/partition.h)
  Stretch stretch = Stretch::Linear;
  int ghostFaces = 0;  ///< 0 = off, else at least 4: the splines run on a ghost mesh with about this number of faces
  Transfer transfer = Transfer::Exact;  ///< with a ghost
  bool optimalPlacement = false;        ///< ghost vertices need not be vertices of the shape (simplify.h)
  Precision precision = Precision::Single;
};

/// The coarse mesh that leads the motion (paper section 4.3, Fig. 6), and how the input belongs to it.
struct Ghost {
  std::vector<Triangle> faces;     ///< of ghost vertices; none without a ghost
  std::vector<int> vertexOf;       ///< of each ghost vertex: the corresponding vertex of the input
  std::vector<int> ghostVertexOf;  ///< of each vertex of the input: the ghost vertex that it collapsed to, or -1
  std::vector<int> ghostFaceOf;    ///< of each face of the input: the ghost face that it follows; -1 without area
};

/// What making the space cost. Neither encodings nor factorisations move while t, the motion options or the key times
/// change. What a motion factors to hold what rests is not counted.
struct LriStats {
  int encodings = 0;
  int factorisations = 0;
  int patches = 0;  ///< of the ghost, with one
  /// Wall time of each stage; the ghost's own systems count as encoding. Arranging lays the faces' numbers out in the
  /// order in which the system is eliminated. Finishing: normals, and the patch and ghost face of each input face.
  double encodeMs = 0, orderMs = 0, factorMs = 0, arrangeMs = 0, finishMs = 0;
  long long factorBytes = 0;  ///< of the stored factor, entries and row lists: what one sweep of a solve reads
  int ghostFaces = 0, ghostVertices = 0;  ///< 0 without a ghost
  int joinedComponents = 0;               ///< components too small for a ghost of their own
  double simplifyMs = 0, transferMs = 0;  ///< with a ghost: collapses; correspondence and residuals
};

/// Encoded poses with their factored systems (paper sections 4.2 and 4.3). Immutable.
class LriSpace {
 public:
  /// What the frames of a shape are computed in.
  struct Scratch {
    PatchMotion::Scratch patches;
    GhostMotion::Scratch ghost;
  };

  /// keys: must outlive the space. progress: stages and fractions of them. order: asked once the poses are encoded;
  /// where it has none, the order is found then. Errors: those of the solver.
  static Result<LriSpace> create(const WeldedKeys& keys, const ShapeTopology& topology, const LriOptions& options,
                                 const StageProgress& progress = {}, OrderSource order = nullptr);

  const VertexNormals& normals() const { return *normals_; }

  /// The patches that everything follows: of the ghost, with one.
  const PatchMotion& patches() const { return ghost_ ? ghost_->patches() : *patches_; }
  /// The ghost that leads the shape, or null.
  const GhostMotion* ghostMotion() const { return ghost_ ? &*ghost_ : nullptr; }
  const Ghost& ghost() const { return ghostOfInput_; }
  /// The mesh that the splines run on: of the ghost, with one.
  const WeldedShape& ledBy() const { return ghost_ ? ghost_->shape() : keys_->shape; }

  /// The frames of the faces at `point`: of patches, or of the ghost's faces.
  void localFramesAt(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const;

  /// Calls visit with the reconstructor, in whichever precision it is.
  template <class Visit>
  decltype(auto) withReconstructor(const Visit& visit) const {
    return std::visit(visit, *reconstructor_);
  }

  /// What a motion that holds what rests is made of (hold/held_motion.h).
  HoldInput holdInput() const;

  const std::vector<int>& slotOf() const;                     ///< reconstruct.h
  const std::vector<AmbiguousFaces>& ambiguousFaces() const;  ///< one per interval between keys

  /// Patch of each face of the welded mesh, and of the input; -1 where it has no area.
  const std::vector<int>& patchOfFace() const { return patchOfFace_; }
  const std::vector<int>& patchOfInputFace() const { return patchOfInputFace_; }

  /// Inner products of the columns in the metric of the coordinates (gram_matrix.h).
  Eigen::MatrixXd gramMatrix() const;
  /// The same of another shape with the columns (encoded_positions.h). weights: those that it belongs to, one per
  /// column, sum 1. positions: of the welded vertices.
  ShapeProducts productsOf(const Positions& positions, const Eigen::VectorXd& weights) const;
  /// Inner products of the columns' vertices: of the ghost's, with one.
  Eigen::MatrixXd vertexGram() const { return vertexGramMatrix(ledBy()); }

  /// The coordinates of a face of the input, numbersPerFace rows: a column per pose. Face must have a patch.
  Eigen::MatrixXd faceColumns(int inputFace) const;
  /// Half the trace of the stretch, the mean over the area of a patch in the reference pose: one per column.
  Eigen::VectorXd patchStretch(int patch) const;

  const std::vector<Warning>& warnings() const { return warnings_; }
  const LriStats& stats() const { return stats_; }

 private:
  using AnyReconstructor = std::variant<Reconstructor<float>, Reconstructor<double>>;

  LriSpace(const WeldedKeys& keys, const LriOptions& options) : keys_(&keys), stretch_(options.stretch) {}
  Status encodePatchesOrGhost(const ShapeTopology& topology, const LriOptions& options, const StageProgress& progress);
  template <class Real>
  Status makeReconstructor(const ShapeTopology& topology, const LriOptions& options, OrderSource order,
                           const StageProgress& progress);
  LocalFramePoses localFramePoses() const { return ghost_ ? ghost_->poses() : patches_->poses(); }
  Eigen::MatrixXd weldedFaceColumns(int face) const;
  // That the metric is made of: the ghost's, with one.
  PoseCoordinates poseCoordinates() const;
  Positions ghostOf(const Positions& positions, const Eigen::VectorXd& weights) const;
  void describeGhost();
  void collectWarnings(int wantedGhostFaces);

  const WeldedKeys* keys_;
  std::optional<PatchMotion> patches_;  // without a ghost
  std::optional<GhostMotion> ghost_;
  std::optional<AnyReconstructor> reconstructor_;
  std::optional<VertexNormals> normals_;
  Ghost ghostOfInput_;
  std::vector<int> patchOfFace_, patchOfInputFace_;
  Stretch stretch_ = Stretch::Linear;
  std::vector<Warning> warnings_;
  LriStats stats_;
};

}  // namespace shapespline
