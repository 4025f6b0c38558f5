#include "core/pose_weights.h"

#include <cmath>

#include "core/precision.h"

namespace shapespline {

PoseWeights poseWeights(const Weights& w, const WeldedShape& shape) {
  const Columns columns{shape.keys};
  PoseWeights result;
  result.column.assign(w.data(), w.data() + shape.keys);
  result.column.resize(shape.columns(), 0);
  if (shape.startTangent >= 0) result.column[shape.startTangent] = w[columns.startTangent()];
  if (shape.endTangent >= 0) result.column[shape.endTangent] = w[columns.endTangent()];
  result.closing = w[columns.closing()];
  result.column[0] += result.closing;
  for (double& weight : result.column)
    if (std::abs(weight) < leastWeight<double>) weight = 0;
  result.keys = shape.keys;
  result.beyond = w.beyond;
  return result;
}

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (weights.column[c] != 0) sum += weights.column[c] * columns[c];
  return sum;
}

}  // namespace shapespline
