#include "core/space/vertex_space.h"

namespace shapespline {

namespace {

VertexNormals normalsOf(const WeldedKeys& keys) {
  return {keys.input.faces, keys.shadingGroup, keys.shadingGroups, keys.input.welding.weldedOfRaw};
}

}  // namespace

void blendVertices(const WeldedShape& shape, std::span<const double> weights, Positions& blended) {
  blended.assign(shape.vertexCount(), Vec3::Zero());
  for (int c = 0; c < shape.columns(); ++c)
    for (std::size_t v = 0; v < blended.size(); ++v) blended[v] += weights[c] * shape.poses[c][v];
}

VertexSpace::VertexSpace(const WeldedKeys& keys) : keys_(&keys), normals_(normalsOf(keys)) {}

void VertexSpace::positions(const CurvePoint& point, Positions& positions) const {
  const WeldedShape& shape = keys_->shape;
  blendVertices(shape, poseWeights(point, shape.roles()).column, positions);
}

}  // namespace shapespline
