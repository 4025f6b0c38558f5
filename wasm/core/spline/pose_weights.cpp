#include "core/spline/pose_weights.h"

#include <cmath>

#include "core/sparse/precision.h"

namespace shapespline {

PoseWeights poseWeights(const CurvePoint& point, const WeldedShape& shape) {
  const Columns columns{shape.keys};
  const Weights& w = point.weights;
  PoseWeights result;
  result.column.assign(w.data(), w.data() + shape.keys);
  result.column.resize(shape.columns(), 0);
  if (shape.startTangent >= 0) result.column[shape.startTangent] = w[columns.startTangent()];
  if (shape.endTangent >= 0) result.column[shape.endTangent] = w[columns.endTangent()];
  for (double& weight : result.column)
    if (std::abs(weight) < leastWeight<double>) weight = 0;
  result.keys = shape.keys;
  result.beyond = point.beyond;
  return result;
}

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (weights.column[c] != 0) sum += weights.column[c] * columns[c];
  return sum;
}

}  // namespace shapespline
