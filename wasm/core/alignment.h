// How the whole shape is turned: patch rotations are found up to a common rotation, which follows the keys.
#pragma once

#include <vector>

#include "core/patches.h"
#include "core/options.h"
#include "core/rotation_path.h"
#include "core/welded_shape.h"

namespace shapespline {

/// Turns reconstructed patch rotations to where the keys have them at any weights.
///
/// The mean rotation R of the paper's coordinates (Eq. 5) is the area-weighted mean of the patch rotations, moved along
/// its cumulative path. Where that mean is badly conditioned at a key or between (a uniform twist by a whole turn has
/// none), a correct shape would flip; then every patch is aligned to its own rotation, moved along a path of its own.
class Alignment {
 public:
  struct Input {
    const Patches& patches;
    const std::vector<double>& patchArea;
    const std::vector<std::vector<Quaternion>>& rotation;  ///< G_k: rotation[column][patch]
    const WeldedShape& shape;
    const std::vector<int>& treeOrder;                     ///< patches, parents first
    const std::vector<int>& treeParent;                    ///< -1 for the root of a piece
  };

  Alignment() = default;
  explicit Alignment(const Input& input);

  /// Decides once which of the two forms is used. sampled: reconstructed rotations of the patches at times between and
  /// beyond the keys.
  void decide(const std::vector<std::vector<Quaternion>>& sampled);

  /// Adds whole turns on the way to keys; replaces those set before.
  void setTurns(const std::vector<AddedTurns>& turns);

  /// The rotation Q that takes `rotation` (any gauge) to its place: G_k <- Q G_k.
  Quaternion at(const Weights& weights, const std::vector<Quaternion>& rotation) const;

  bool byPatches() const { return byPatches_; }

  /// Largest angle of the mean rotation's increments between keys, radians: above 150 degrees the keys leave open which
  /// way and how often the shape turned.
  double largestIncrement() const;

  /// Rotation that a periodic motion adds in one period where its last key closes it: R_J R_1^T.
  Quaternion periodRotation() const;

 private:
  void buildPatchPaths(const Input& input);
  Quaternion meanOf(const std::vector<Quaternion>& rotation) const;

  std::vector<double> area_;
  RotationPath mean_, meanWithoutTurns_;
  std::vector<RotationPath> patch_, patchWithoutTurns_;
  bool byPatches_ = false;
  int keys_ = 0;
  double smallestCondition_ = 1;
};

}  // namespace shapespline
