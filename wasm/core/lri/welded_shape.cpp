#include "core/lri/welded_shape.h"

#include "core/lri/torn_faces.h"

namespace shapespline {

FaceFrame frameIn(const WeldedShape& shape, int face, int column) {
  const Positions& p = shape.poses[column];
  const Triangle& t = shape.faces[face];
  return faceFrame(p[t[0]], p[t[1]], p[t[2]]);
}

FaceFrame referenceFrame(const WeldedShape& shape, int face) { return frameIn(shape, face, shape.reference); }

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
  std::vector<const Positions*> poses;
  for (const Positions& p : shape.poses) poses.push_back(&p);
  topology.hasArea = facesWithArea(shape.faces, poses, partOf(onProgress, 0, 0.2));
  topology.turns = topology.hasArea;
  const auto connect = [&](const FractionReport& report) {
    topology.graph = dualGraph(shape.vertexCount(), shape.faces, topology.turns, partOf(report, 0, 0.9));
    topology.components = connectedComponents(topology.graph, topology.turns, partOf(report, 0.9, 1));
  };
  connect(partOf(onProgress, 0.2, 1));
  topology.solved = topology.components;
  topology.torn = tornShares(shape, topology.hasArea, topology.solved);
  for (std::size_t f = 0; f < topology.torn.size(); ++f)
    if (topology.torn[f] == 1) topology.turns[f] = 0;
  if (topology.turns != topology.hasArea) connect({});
  topology.anchor = anchorsOf(shape, topology);
  reportFraction(onProgress, 1);
  if (topology.components.count == 0) return topology;
  topology.tree = linkComponents(shape.faces, topology.components, poses);
  return topology;
}

}  // namespace shapespline
