#include "core/spline/pose_weights.h"

#include <cmath>

namespace shapespline {

PoseWeights poseWeights(const CurvePoint& point, const PoseRoles& roles) {
  const Columns columns{roles.keys};
  const Weights& w = point.weights;
  PoseWeights result;
  result.column.assign(w.data(), w.data() + roles.keys);
  result.column.resize(roles.count(), 0);
  if (roles.startTangent >= 0) result.column[roles.startTangent] = w[columns.startTangent()];
  if (roles.endTangent >= 0) result.column[roles.endTangent] = w[columns.endTangent()];
  for (double& weight : result.column)
    if (std::abs(weight) < minWeight<double>) weight = 0;
  result.keys = roles.keys;
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
