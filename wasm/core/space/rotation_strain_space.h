// Rotation-strain coordinates (Huang et al. 2011) by increments: separate rotations and stretches of the faces.
#pragma once

#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// Rotations R_f of this space. Stretches, system and placement come from LRI space, for the shape itself even with a
/// ghost. Rotating a whole key changes the motion. Immutable.
class RotationStrainSpace {
 public:
  /// Both must outlive the space. Requires stretches of the shape's faces, so not with Transfer::Paper.
  RotationStrainSpace(const WeldedKeys& keys, const LriSpace& lri);

  /// Real: the type of LRI space's reconstructor.
  template <class Real>
  void rotationsAt(const CurvePoint& point, RotationBlocks<Real>& rotations, ForkJoin* forkJoin = nullptr) const {
    std::get<RotationPaths<Real>>(paths_).at(point, wholeTurn(point), rotations, forkJoin);
  }

  /// One entry per interval between keys (lifted_paths.h).
  const std::vector<AmbiguousFaces>& tornFaces() const { return torn_; }

  /// Inner products of the columns (path_gram.h), with faces weighted by area.
  Eigen::MatrixXd gramMatrix() const;

 private:
  Quaternion wholeTurn(const CurvePoint& point) const;

  const WeldedKeys* keys_;
  const LriSpace* lri_;
  std::variant<RotationPaths<float>, RotationPaths<double>> paths_;
  std::vector<AmbiguousFaces> torn_;
};

}  // namespace shapespline
