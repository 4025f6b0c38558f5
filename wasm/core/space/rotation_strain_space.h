// Rotation-strain coordinates (Huang et al. 2011), by increments: what each face turns and stretches by itself.
#pragma once

#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// The rotations R_f of this space beside the stretches, the system and the placement of LRI space, of the shape itself
/// even where a ghost leads that. A key that is turned as a whole changes the motion. Immutable.
class RotationStrainSpace {
 public:
  /// Both must outlive the space. The stretches must be those of the shape's own faces: not with Transfer::Paper.
  RotationStrainSpace(const WeldedKeys& keys, const LriSpace& lri);

  /// Real: of LRI space's reconstructor.
  template <class Real>
  void rotationsAt(const CurvePoint& point, RotationBlocks<Real>& rotations, ForkJoin* forkJoin = nullptr) const {
    std::get<RotationPaths<Real>>(paths_).at(point, wholeTurn(point), rotations, forkJoin);
  }

  /// One per interval between keys (lifted_paths.h).
  const std::vector<AmbiguousFaces>& tornFaces() const { return torn_; }

  /// Inner products of the columns (path_gram.h), faces by their share of the area.
  Eigen::MatrixXd gramMatrix() const;

 private:
  Quaternion wholeTurn(const CurvePoint& point) const;

  const WeldedKeys* keys_;
  const LriSpace* lri_;
  std::variant<RotationPaths<float>, RotationPaths<double>> paths_;
  std::vector<AmbiguousFaces> torn_;
};

}  // namespace shapespline
