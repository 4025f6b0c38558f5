#include "core/lri/welded_shape.h"

#include <algorithm>

namespace shapespline {

FaceFrame referenceFrame(const WeldedShape& shape, int face) {
  const Positions& p = shape.poses[shape.reference];
  const Triangle& t = shape.faces[face];
  return faceFrame(p[t[0]], p[t[1]], p[t[2]]);
}

FaceDeformation deformationOf(const WeldedShape& shape, int face, const FaceFrame& frame, int column) {
  const Positions& p = shape.poses[column];
  const Triangle& t = shape.faces[face];
  return deformation(frame, p[t[0]], p[t[1]], p[t[2]]);
}

Quaternion rotationOf(const WeldedShape& shape, int face, int column) {
  return Quaternion(deformationOf(shape, face, referenceFrame(shape, face), column).rotation);
}

ShapeTopology topologyOf(const WeldedShape& shape, const FractionReport& onProgress) {
  ShapeTopology topology;
  topology.hasArea.resize(shape.faceCount());
  inBlocks(partOf(onProgress, 0, 0.2), topology.hasArea.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& t = shape.faces[f];
      topology.hasArea[f] = std::none_of(shape.poses.begin(), shape.poses.end(),
                                         [&](const Positions& p) { return isDegenerate(p[t[0]], p[t[1]], p[t[2]]); });
    }
  });
  topology.graph = dualGraph(shape.vertexCount(), shape.faces, topology.hasArea, partOf(onProgress, 0.2, 0.9));
  topology.components = connectedComponents(topology.graph, topology.hasArea, partOf(onProgress, 0.9, 1));
  reportFraction(onProgress, 1);
  if (topology.components.count == 0) return topology;
  std::vector<const Positions*> poses;
  for (const Positions& p : shape.poses) poses.push_back(&p);
  topology.tree = linkComponents(shape.faces, topology.components, poses);
  return topology;
}

}  // namespace shapespline
