// The metric of shape space, and its plane of largest variance (Fig. 2b).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/types.h"
#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"
#include "core/space/encoded_positions.h"

namespace shapespline {

/// Inner products of the coordinates' columns (poses), columns x columns. The metric weights face numbers by the face's
/// share of the area and patch pairs by their share of the shared edges, and divides mean positions by the
/// diagonal. Angles are in radians. The mean rotation has its own path and is excluded.
/// other: an additional shape as the last row and column, or null.
Eigen::MatrixXd gramMatrix(const PoseCoordinates& poses, const WeldedShape& shape, double diagonal,
                           const ShapeCoordinates* other = nullptr);

/// Adds `weight` times the inner products of numbers of all shapes. numbers: shapes x count, row by row.
void addProducts(Eigen::MatrixXd& gram, double weight, const std::vector<double>& numbers);

/// Inner products of the poses' vertices, as a mean over the vertices: the metric of vertex blends.
Eigen::MatrixXd vertexGramMatrix(const WeldedShape& shape);

/// A shape by its inner products with the columns and with itself.
struct ShapeProducts {
  Eigen::VectorXd columns;
  double squared = 0;
};

/// Principal component analysis: the plane of the two leading components of the first `keys` columns. If the keys are
/// on one line, the second axis is towards the later column farthest from it (Fig. 3: two keys and their tangents).
class PrincipalPlane {
 public:
  PrincipalPlane(const Eigen::MatrixXd& gram, int keys);
  /// Coordinates of an affine combination of the columns, and of any shape.
  Vec2 project(const Eigen::VectorXd& columnWeights) const { return project(productsOf(columnWeights)); }
  Vec2 project(const ShapeProducts& shape) const;
  /// Distance of a shape from the plane, in the metric.
  double distance(const ShapeProducts& shape) const;
  ShapeProducts productsOf(const Eigen::VectorXd& columnWeights) const;
  /// Share of the keys' variance in the plane, in [0, 1].
  double explained() const { return explained_; }

 private:
  void leanTowards(Eigen::Index firstColumn, double minSquare);

  Eigen::MatrixXd gram_;
  Eigen::VectorXd mean_;       // weights of the mean of the keys
  Eigen::MatrixXd direction_;  // columns x 2: weights of the axes, with unit length in the metric
  double explained_ = 0;
};

}  // namespace shapespline
