#include "core/space/vertex_space.h"

namespace shapespline {

namespace {

VertexNormals normalsOf(const WeldedKeys& keys) {
  return {keys.input.faces, keys.shadingGroup, keys.shadingGroups, keys.input.welding.weldedOfRaw};
}

// Adds what a key of another period is turned about its mean position. The motion adds the path of the mean position.
void addTurn(const WeldedShape& shape, const std::vector<Vec3>& meanPosition, const KeyWeight& k, Positions& blended) {
  const Mat3 turn = k.weight * (shape.closing->power(k.period).rotation.toRotationMatrix() - Mat3::Identity());
  for (std::size_t v = 0; v < blended.size(); ++v) blended[v] += turn * (shape.poses[k.key][v] - meanPosition[k.key]);
}

}  // namespace

void blendVertices(const WeldedShape& shape, std::span<const double> weights, Positions& blended) {
  blended.assign(shape.vertexCount(), Vec3::Zero());
  for (int c = 0; c < shape.columns(); ++c)
    for (std::size_t v = 0; v < blended.size(); ++v) blended[v] += weights[c] * shape.poses[c][v];
}

void blendVertices(const WeldedShape& shape, const std::vector<Vec3>& meanPosition, const CurvePoint& point,
                   Positions& blended) {
  blendVertices(shape, poseWeights(point, shape.roles()).column, blended);
  if (!shape.closing || point.closes) return;
  for (const KeyWeight& k : point.unrolled)
    if (k.period != 0) addTurn(shape, meanPosition, k, blended);
}

VertexSpace::VertexSpace(const WeldedKeys& keys) : keys_(&keys), normals_(normalsOf(keys)) {}

void VertexSpace::positions(const CurvePoint& point, Positions& positions) const {
  blendVertices(keys_->shape, keys_->meanPosition, point, positions);
}

}  // namespace shapespline
