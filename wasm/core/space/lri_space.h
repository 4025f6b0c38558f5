// LRI space of a shape: its patches or its ghost, the coordinates of its poses, and the factored systems.
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

/// Options that change the coordinates.
struct LriOptions {
  int patches =
      0;  ///< requested number of patches (of the ghost, if any); 0 = the default formula (patches/partition.h)
  Stretch stretch = Stretch::Linear;
  /// approximate number of faces of the ghost mesh on which the motion is computed, at least 4; 0 = no ghost mesh
  int ghostFaces = 0;
  Transfer transfer = Transfer::Exact;  ///< only with a ghost
  bool optimalPlacement = false;        ///< ghost vertices may leave the shape's vertices (simplify.h)
  Precision precision = Precision::Single;
};

/// The coarse mesh that drives the motion (paper section 4.3, Fig. 6), and its correspondence with the input.
struct Ghost {
  std::vector<Triangle> faces;     ///< indices of ghost vertices; empty without a ghost
  std::vector<int> vertexOf;       ///< corresponding input vertex of each ghost vertex
  std::vector<int> ghostVertexOf;  ///< ghost vertex that each input vertex collapsed to, or -1
  std::vector<int> ghostFaceOf;    ///< ghost face that each input face follows; -1 for a face without area
};

/// Costs of building the space. Encodings and factorisations do not change with t, motion options or key times.
/// Factorisations for holding are not counted.
struct LriStats {
  int encodings = 0;
  int factorisations = 0;
  int patches = 0;  ///< patches of the ghost, if any
  /// Wall time of each stage. The ghost's systems count as encoding. Arranging sorts the faces' numbers by the
  /// elimination order of the system. Finishing: normals, and the patch and ghost face of each input face.
  double encodeMs = 0, orderMs = 0, factorMs = 0, arrangeMs = 0, finishMs = 0;
  long long factorBytes = 0;  ///< entries and row lists of the stored factor: the data read by one sweep of a solve
  int ghostFaces = 0, ghostVertices = 0;  ///< 0 without a ghost
  int joinedComponents = 0;               ///< components too small for a ghost of their own
  double simplifyMs = 0, transferMs = 0;  ///< only with a ghost: collapses; correspondence and residuals
};

/// Encoded poses with their factored systems (paper sections 4.2 and 4.3). Immutable.
class LriSpace {
 public:
  /// Scratch memory for the frames of a shape.
  struct Scratch {
    PatchMotion::Scratch patches;
    GhostMotion::Scratch ghost;
  };

  /// keys: must outlive the space. progress: stages and their fractions. order: called after encoding; if it provides
  /// no order, one is computed. Errors: the solver's.
  static Result<LriSpace> create(const WeldedKeys& keys, const ShapeTopology& topology, const LriOptions& options,
                                 const StageProgress& progress = {}, OrderSource order = nullptr);

  const VertexNormals& normals() const { return *normals_; }

  /// The patches that drive the motion: the ghost's, if any.
  const PatchMotion& patches() const { return ghost_ ? ghost_->patches() : *patches_; }
  /// The ghost that drives the shape, or null.
  const GhostMotion* ghostMotion() const { return ghost_ ? &*ghost_ : nullptr; }
  const Ghost& ghost() const { return ghostOfInput_; }
  /// The mesh of the splines: the ghost, if any.
  const WeldedShape& ledBy() const { return ghost_ ? ghost_->shape() : keys_->shape; }

  /// The faces' local frames at `point`: patches, or faces of the ghost.
  void localFramesAt(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const;

  /// Calls visit with the reconstructor in its precision.
  template <class Visit>
  decltype(auto) withReconstructor(const Visit& visit) const {
    return std::visit(visit, *reconstructor_);
  }

  /// Input for holding (hold/held_motion.h).
  HoldInput holdInput() const;

  const std::vector<int>& slotOf() const;                     ///< see reconstruct.h
  const std::vector<AmbiguousFaces>& ambiguousFaces() const;  ///< one entry per interval between keys

  /// Patch of each face of the welded mesh, and of the input; -1 without area.
  const std::vector<int>& patchOfFace() const { return patchOfFace_; }
  const std::vector<int>& patchOfInputFace() const { return patchOfInputFace_; }

  /// Inner products of the columns in the metric of coordinates (gram_matrix.h).
  Eigen::MatrixXd gramMatrix() const;
  /// Inner products of another shape with the columns (encoded_positions.h). weights: one per column, sum 1; the shape
  /// belongs to them. positions: welded vertices.
  ShapeProducts productsOf(const Positions& positions, const Eigen::VectorXd& weights) const;
  /// Inner products of the columns' vertices (of the ghost's, if any).
  Eigen::MatrixXd vertexGram() const { return vertexGramMatrix(ledBy()); }

  /// Coordinates of an input face: numbersPerFace rows, one column per pose. The face must have a patch.
  Eigen::MatrixXd faceColumns(int inputFace) const;
  /// Half the trace of the stretch, averaged over a patch's area in the reference pose: one value per column.
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
  // Coordinates for the metric: the ghost's, if any.
  PoseCoordinates poseCoordinates() const;
  Positions ghostOf(const Positions& positions, const Eigen::VectorXd& weights) const;
  bool missesKeys() const;
  void describeGhost();
  void collectWarnings(int wantedGhostFaces);

  const WeldedKeys* keys_;
  std::optional<PatchMotion> patches_;  // empty with a ghost
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
