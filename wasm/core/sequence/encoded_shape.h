// The poses of a shape and the spaces for its motions. They are expensive to build and independent of time.
#pragma once

#include <cassert>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/warning.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "core/sequence/sequence_stats.h"
#include "core/space/lri_space.h"
#include "core/space/rimd_space.h"
#include "core/space/rotation_strain_space.h"
#include "core/space/vertex_space.h"

namespace shapespline {

/// Welded poses, and each space once a motion needs it. A space never changes after it is built.
class EncodedShape {
 public:
  /// keyframes: freed after welding. Errors: those of weldKeys(), and NoArea.
  static Result<EncodedShape> build(Keyframes keyframes, const EncodingOptions& options,
                                    const StageProgress& progress = {});

  const WeldedShape& shape() const { return keys_->shape; }  ///< the mesh in canonical order
  const InputMesh& input() const { return keys_->input; }
  const std::vector<Vec3>& meanPosition() const { return keys_->meanPosition; }  ///< one per column

  /// Builds LRI space unless it exists. Arguments and errors as for LriSpace::create.
  Status makeLri(const StageProgress& progress = {}, OrderSource order = nullptr);
  /// Builds the space of vertex positions unless it exists.
  void makeVertices();

  /// Builds a space with separate face rotations unless it exists. LRI space must exist. Error: InvalidOption if faces
  /// have no separate stretches.
  Status makeFaceSpace(Method method);

  /// LRI space must exist.
  const LriSpace& lri() const {
    assert(lri_);
    return *lri_;
  }
  const VertexSpace& vertices() const {
    assert(vertices_);
    return *vertices_;
  }
  const RotationStrainSpace& rotationStrain() const {
    assert(rotationStrain_);
    return *rotationStrain_;
  }
  const RimdSpace& rimd() const {
    assert(rimd_);
    return *rimd_;
  }
  bool hasLri() const { return lri_ != nullptr; }

  /// Component of each input face, numbered by its first face in the input; -1 without area.
  const std::vector<int>& componentOfInputFace() const { return componentOfInputFace_; }
  int componentCount() const { return static_cast<int>(firstFaceOf_.size()); }

  /// Converts turns of the input's components, and of the whole, to turns of LRI space's patches.
  PatchTurns turnsOfPatches(std::vector<AddedTurns> turns) const;
  /// Converts component numbers to those of the patches: with a ghost, the ghost's components.
  std::vector<AddedTurns> turnsOfPatchComponents(std::vector<AddedTurns> turns) const;

  /// Warnings about the keys that do not depend on the motion.
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// The parts built so far, and their costs.
  BuildStats stats() const;

 private:
  Status checkStretches() const;
  EncodedShape(WeldedKeys keys, const EncodingOptions& options)
      : keys_(std::make_unique<const WeldedKeys>(std::move(keys))), options_(options) {}
  void numberComponents();
  void findMirroredKeys();

  std::unique_ptr<const WeldedKeys> keys_;  // the other members refer to it
  LriOptions options_;
  std::optional<ShapeTopology> topology_;  // empty after LRI space is built
  std::unique_ptr<const LriSpace> lri_;
  std::optional<VertexSpace> vertices_;
  std::unique_ptr<const RotationStrainSpace> rotationStrain_;
  std::unique_ptr<const RimdSpace> rimd_;
  std::vector<int> componentOfInputFace_;
  std::vector<int> firstFaceOf_;  // a face of each component in the welded mesh, whose part carries the others
  std::vector<Warning> warnings_;
  BuildStats stats_;
};

}  // namespace shapespline
