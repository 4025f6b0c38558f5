// The metric of shape space, and its plane of largest variance (Fig. 2b).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/types.h"
#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"

namespace shapespline {

/// Inner products of the coordinates' columns (poses), columns x columns. The metric: face numbers weighted by the
/// face's share of the reference area, patch pairs by their share of the shared edges, mean positions over the
/// diagonal; angles in radians. The mean rotation moves on its own path and is left out.
template <class Real>
Eigen::MatrixXd gramMatrix(const PatchCoordinates& patches, const LriCoordinates<Real>& coordinates,
                           const WeldedShape& shape, double diagonal);

/// Principal component analysis: the plane of the two leading components of the first `keys` columns.
class PrincipalPlane {
 public:
  PrincipalPlane(const Eigen::MatrixXd& gram, int keys);
  /// Coordinates of an affine combination of the columns.
  Vec2 project(const Eigen::VectorXd& columnWeights) const;
  /// Share of the keys' variance in the plane, in [0, 1].
  double explained() const { return explained_; }

 private:
  Eigen::MatrixXd gram_;
  Eigen::VectorXd mean_;       // weights of the keys' mean
  Eigen::MatrixXd direction_;  // columns x 2: weights of the axes, unit length in the metric
  double explained_ = 0;
};

}  // namespace shapespline
