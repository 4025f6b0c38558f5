// The poses of a shape, and the spaces that its motions are made in: what is costly to make and knows no time.
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

/// Welded poses, and each space from when a motion first needs it. A space never changes once it is made.
class EncodedShape {
 public:
  /// keyframes: freed once they are welded. Errors: those of weldKeys(), and NoArea.
  static Result<EncodedShape> build(Keyframes keyframes, const EncodingOptions& options,
                                    const StageProgress& progress = {});

  const WeldedShape& shape() const { return keys_->shape; }  ///< its mesh in canonical order
  const InputMesh& input() const { return keys_->input; }
  const std::vector<Vec3>& meanPosition() const { return keys_->meanPosition; }  ///< one per column

  /// Makes LRI space where it is not there. Arguments and errors as for LriSpace::create.
  Status makeLri(const StageProgress& progress = {}, OrderSource order = nullptr);
  /// Makes the space of vertex positions where it is not there.
  void makeVertices();

  /// Makes a space in which faces rotate by themselves where it is not there; LRI space must have been made. Error:
  /// InvalidOption where the shape has no stretches of its own.
  Status makeFaceSpace(Method method);

  /// The same of own paths. base: not Off.
  Status makeOwnPaths(OwnPaths base);

  /// It must have been made.
  const LriSpace& lri() const { return assert(lri_), *lri_; }
  const VertexSpace& vertices() const { return assert(vertices_), *vertices_; }
  const RotationStrainSpace& rotationStrain() const { return assert(rotationStrain_), *rotationStrain_; }
  const RimdSpace& rimd() const { return assert(rimd_), *rimd_; }
  const OwnPathsSpace& ownPaths(OwnPaths base) const { return *(base == OwnPaths::Root ? rootPaths_ : ownPaths_); }
  bool hasLri() const { return lri_ != nullptr; }

  /// Component of each face of the input, numbered by their first faces there; -1 where it has no area.
  const std::vector<int>& componentOfInputFace() const { return componentOfInputFace_; }
  int componentCount() const { return static_cast<int>(firstFaceOf_.size()); }

  /// Turns of the input's components, and of the whole, taken to the patches of LRI space.
  PatchTurns turnsOfPatches(std::vector<AddedTurns> turns) const;
  /// The components as the patches count them: with a ghost both are its own.
  std::vector<AddedTurns> turnsOfPatchComponents(std::vector<AddedTurns> turns) const;

  /// What the keys say, whatever the motion.
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// What was made so far, and what it cost.
  BuildStats stats() const;

 private:
  Status checkStretches() const;
  EncodedShape(WeldedKeys keys, const EncodingOptions& options)
      : keys_(std::make_unique<const WeldedKeys>(std::move(keys))), options_(options) {}
  void numberComponents();
  void findMirroredKeys();

  std::unique_ptr<const WeldedKeys> keys_;  // what follows refers to it
  LriOptions options_;
  std::optional<ShapeTopology> topology_;  // until LRI space is made
  std::unique_ptr<const LriSpace> lri_;
  std::optional<VertexSpace> vertices_;
  std::unique_ptr<const RotationStrainSpace> rotationStrain_;
  std::unique_ptr<const RimdSpace> rimd_;
  std::unique_ptr<const OwnPathsSpace> ownPaths_, rootPaths_;  // absolute, and against the largest frame
  std::vector<int> componentOfInputFace_;
  std::vector<int> firstFaceOf_;  // of each component, in the welded mesh
  std::vector<Warning> warnings_;
  BuildStats stats_;
};

}  // namespace shapespline
