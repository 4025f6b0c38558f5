// The metric of shape space, and its plane of largest variance (Fig. 2b).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/types.h"
#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"
#include "core/space/encoded_positions.h"

namespace shapespline {

/// Inner products of the coordinates' columns (poses), columns x columns. The metric: face numbers weighted by the
/// face's share of the reference area, patch pairs by their share of the shared edges, mean positions over the
/// diagonal; angles in radians. The mean rotation moves on its own path and is left out.
/// other: null, or one more shape, which becomes the last row and column.
Eigen::MatrixXd gramMatrix(const PoseCoordinates& poses, const WeldedShape& shape, double diagonal,
                           const ShapeCoordinates* other = nullptr);

/// Adds `weight` times the inner products of some numbers of all shapes; numbers: shapes x count, row by row.
void addProducts(Eigen::MatrixXd& gram, double weight, const std::vector<double>& numbers);

/// Inner products of the poses' vertices, mean over the vertices: the metric that blends of vertices are made in.
Eigen::MatrixXd vertexGramMatrix(const WeldedShape& shape);

/// A shape by its inner products with the columns and with itself.
struct ShapeProducts {
  Eigen::VectorXd columns;
  double squared = 0;
};

/// Principal component analysis: the plane of the two leading components of the first `keys` columns. Keys on one line
/// leave the second axis to the column behind them that is farthest from it (Fig. 3: two keys and their tangents).
class PrincipalPlane {
 public:
  PrincipalPlane(const Eigen::MatrixXd& gram, int keys);
  /// Coordinates of an affine combination of the columns, and of any shape.
  Vec2 project(const Eigen::VectorXd& columnWeights) const { return project(productsOf(columnWeights)); }
  Vec2 project(const ShapeProducts& shape) const;
  /// How far it is from the plane, in the metric.
  double distance(const ShapeProducts& shape) const;
  ShapeProducts productsOf(const Eigen::VectorXd& columnWeights) const;
  /// Share of the keys' variance in the plane, in [0, 1].
  double explained() const { return explained_; }

 private:
  void leanTowards(Eigen::Index firstColumn, double leastSquare);

  Eigen::MatrixXd gram_;
  Eigen::VectorXd mean_;       // weights of the keys' mean
  Eigen::MatrixXd direction_;  // columns x 2: weights of the axes, unit length in the metric
  double explained_ = 0;
};

}  // namespace shapespline
