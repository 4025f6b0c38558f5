// The poses of a shape, encoded: what is costly to make and knows no time.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/base/warning.h"
#include "core/ghost/ghost_motion.h"
#include "core/hold/held_motion.h"
#include "core/hold/pinned_motion.h"
#include "core/mesh/vertex_normals.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"
#include "core/sequence/elimination_order.h"
#include "core/sequence/gram_matrix.h"
#include "core/sequence/input_mesh.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "core/sequence/sequence_stats.h"
#include "core/sequence/welded_keys.h"

namespace shapespline {

/// The coarse mesh that leads the motion (paper section 4.3, Fig. 6), and how the input belongs to it.
struct Ghost {
  std::vector<Triangle> faces;     ///< of ghost vertices; none without a ghost
  std::vector<int> vertexOf;       ///< of each ghost vertex: the corresponding vertex of the input
  std::vector<int> ghostVertexOf;  ///< of each vertex of the input: the ghost vertex that it collapsed to, or -1
  std::vector<int> ghostFaceOf;    ///< of each face of the input: the ghost face that it follows; -1 without area
};

/// What the frames of a shape are computed in.
struct FramesScratch {
  PatchMotion::Scratch patches;
  GhostMotion::Scratch ghost;
};

/// Welded, partitioned and encoded poses with their factored systems (paper sections 4.2 and 4.3). Immutable; holds no
/// pose of the input.
class EncodedShape {
 public:
  /// keyframes: freed once they are welded. progress: stages and fractions as in build_progress.h. order: asked once
  /// the poses are encoded; where it has none, the order is found then. Errors: those of weldKeys(), NoArea, and those
  /// of the solver.
  static Result<EncodedShape> build(Keyframes keyframes, const EncodingOptions& options,
                                    const StageProgress& progress = {}, OrderSource order = nullptr);

  const WeldedShape& shape() const { return *shape_; }  ///< its mesh in canonical order
  const InputMesh& input() const { return input_; }
  const VertexNormals& normals() const { return *normals_; }
  double diagonal() const { return diagonal_; }  ///< the largest of one pose

  /// The patches that everything follows: of the ghost, with one.
  const PatchMotion& patches() const { return ghost_ ? ghost_->patches() : *patches_; }
  /// The ghost that leads the shape, or null.
  const GhostMotion* ghostMotion() const { return ghost_ ? &*ghost_ : nullptr; }
  const Ghost& ghost() const { return ghostOfInput_; }

  /// The frames of the faces at `point`: of patches, or of the ghost's faces.
  void framesAt(const CurvePoint& point, const PatchTurns& turns, FramesScratch& scratch, Frames& frames) const;
  FramePoses framePoses() const { return ghost_ ? ghost_->poses() : patches_->poses(); }

  /// Calls visit with the reconstructor, in whichever precision it is.
  template <class Visit>
  decltype(auto) withReconstructor(const Visit& visit) const {
    return std::visit(visit, *reconstructor_);
  }

  /// What a motion that holds what rests is made of (hold/held_motion.h).
  HoldInput holdInput() const;

  const std::vector<Vec3>& meanPosition() const;              ///< one per column
  const std::vector<int>& placeOf() const;                    ///< reconstruct.h
  const std::vector<AmbiguousFaces>& ambiguousFaces() const;  ///< one per interval between keys

  /// Patch of each face of the welded mesh, and of the input; -1 where it has no area.
  const std::vector<int>& patchOfFace() const { return patchOfFace_; }
  const std::vector<int>& patchOfInputFace() const { return patchOfInputFace_; }
  /// Component of each face of the input, numbered by their first faces there; -1 where it has no area.
  const std::vector<int>& componentOfInputFace() const { return componentOfInputFace_; }
  int componentCount() const { return static_cast<int>(firstFaceOf_.size()); }

  /// Turns of the input's components, and of the whole, taken to the patches.
  PatchTurns turnsOfPatches(std::vector<AddedTurns> turns) const;
  /// The components as the patches count them: with a ghost both are its own.
  std::vector<AddedTurns> turnsOfPatchComponents(std::vector<AddedTurns> turns) const;

  /// Inner products of the columns in the metric of the coordinates (gram_matrix.h).
  Eigen::MatrixXd gramMatrix() const;
  /// The same of a blend of vertices with the columns (vertex_blend.h). weights: one per column, sum 1.
  ShapeProducts vertexBlendProducts(const Eigen::VectorXd& weights) const;
  /// Inner products of the columns' vertices: of the ghost's, with one.
  Eigen::MatrixXd vertexGram() const { return vertexGramMatrix(ghost_ ? ghost_->shape() : *shape_); }

  /// The coordinates of a face of the input, numbersPerFace rows: a column per pose. Face must have a patch.
  Eigen::MatrixXd faceColumns(int inputFace) const;
  /// Half the trace of the stretch, the mean over the area of a patch in the reference pose: one per column.
  Eigen::VectorXd patchStretch(int patch) const;

  /// What the keys say, whatever the motion.
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// What the building cost.
  const BuildStats& stats() const { return stats_; }

 private:
  using AnyReconstructor = std::variant<Reconstructor<float>, Reconstructor<double>>;

  EncodedShape(WeldedKeys keys, Stretch stretch);
  Status encodePoses(const EncodingOptions& options, OrderSource order, const StageProgress& progress);
  template <class Real>
  Status makeReconstructor(const ShapeTopology& topology, const EncodingOptions& options, OrderSource order,
                           const StageProgress& progress);
  Eigen::MatrixXd weldedFaceColumns(int face) const;
  void prepareNormals(const Positions& normals, const FractionReport& onProgress);
  /// That the metric is made of: the ghost's, with one.
  PoseCoordinates poseCoordinates() const;
  void describeGhost();
  void numberComponents();
  void collectWarnings(int wantedGhostFaces);

  InputMesh input_;
  std::unique_ptr<const WeldedShape> shape_;  // what follows refers to it
  std::optional<PatchMotion> patches_;        // without a ghost
  std::optional<GhostMotion> ghost_;
  std::optional<AnyReconstructor> reconstructor_;
  std::optional<VertexNormals> normals_;
  Ghost ghostOfInput_;
  std::vector<int> patchOfFace_, patchOfInputFace_, componentOfInputFace_;
  std::vector<int> firstFaceOf_;  // of each component, in the welded mesh
  double diagonal_ = 0;
  Stretch stretch_ = Stretch::Linear;
  std::vector<Warning> warnings_;
  BuildStats stats_;
};

}  // namespace shapespline
