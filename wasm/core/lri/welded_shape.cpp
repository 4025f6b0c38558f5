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

ShapeParts partsOf(const WeldedShape& shape, const FractionReport& onProgress) {
  ShapeParts parts;
  parts.hasArea.resize(shape.faceCount());
  inBlocks(partOf(onProgress, 0, 0.2), parts.hasArea.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& t = shape.faces[f];
      parts.hasArea[f] = std::none_of(shape.poses.begin(), shape.poses.end(),
                                      [&](const Positions& p) { return isDegenerate(p[t[0]], p[t[1]], p[t[2]]); });
    }
  });
  parts.graph = dualGraph(shape.vertexCount(), shape.faces, parts.hasArea, partOf(onProgress, 0.2, 0.9));
  parts.pieces = connectedPieces(parts.graph, parts.hasArea, partOf(onProgress, 0.9, 1));
  reportFraction(onProgress, 1);
  if (parts.pieces.count == 0) return parts;
  std::vector<const Positions*> poses;
  for (const Positions& p : shape.poses) poses.push_back(&p);
  parts.tree = linkComponents(shape.faces, parts.pieces, poses);
  return parts;
}

}  // namespace shapespline
