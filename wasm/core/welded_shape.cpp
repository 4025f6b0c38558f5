#include "core/welded_shape.h"

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

ShapeParts partsOf(const WeldedShape& shape) {
  ShapeParts parts;
  parts.hasArea.resize(shape.faceCount());
  for (int f = 0; f < shape.faceCount(); ++f) {
    const Triangle& t = shape.faces[f];
    parts.hasArea[f] = std::none_of(shape.poses.begin(), shape.poses.end(),
                                    [&](const Positions& p) { return isDegenerate(p[t[0]], p[t[1]], p[t[2]]); });
  }
  parts.graph = dualGraph(shape.vertexCount(), shape.faces, parts.hasArea);
  parts.pieces = connectedPieces(parts.graph, parts.hasArea);
  if (parts.pieces.count == 0) return parts;
  std::vector<const Positions*> poses;
  for (const Positions& p : shape.poses) poses.push_back(&p);
  parts.tree = linkComponents(shape.faces, parts.pieces, poses);
  return parts;
}

}  // namespace shapespline
