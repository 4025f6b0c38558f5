#include "core/sequence/mesh_report.h"

#include <algorithm>

#include "core/mesh/weld.h"

namespace shapespline {

MeshReport reportOf(const Keyframes& keyframes, const FractionReport& onProgress) {
  std::vector<const Positions*> poses;
  for (const Key& key : keyframes.keys) poses.push_back(&key.positions);

  MeshReport report;
  report.vertices = keyframes.vertexCount();
  report.faces = keyframes.faceCount();
  report.diagonal = boundingDiagonal(poses);
  report.unreferencedVertices = countUnreferenced(report.vertices, keyframes.faces);
  const Welding welding = weld(poses, weldTolerances(poses), partOf(onProgress, 0.05, 0.3));
  report.weldedVertices = welding.count;
  const std::vector<Triangle> faces = weldFaces(keyframes.faces, welding);
  report.counts = countMesh(welding.count, faces, partOf(onProgress, 0.3, 0.8));
  const std::vector<char> use = facesWithArea(keyframes.faces, poses, partOf(onProgress, 0.8, 0.9));
  report.degenerateFaces = static_cast<int>(std::count(use.begin(), use.end(), 0));
  report.components = countComponents(welding.count, faces, use, partOf(onProgress, 0.9, 1));
  return report;
}

}  // namespace shapespline
