#include "core/mesh_report.h"

#include "core/face_frame.h"
#include "core/weld.h"

namespace shapespline {
namespace {

/// Of each face whether it has area in every key.
std::vector<char> facesWithArea(const Keyframes& keyframes) {
  std::vector<char> use(keyframes.faces.size(), 1);
  for (const Key& key : keyframes.keys) {
    for (std::size_t f = 0; f < use.size(); ++f) {
      const auto& [a, b, c] = keyframes.faces[f];
      if (isDegenerate(key.positions[a], key.positions[b], key.positions[c])) use[f] = 0;
    }
  }
  return use;
}

}  // namespace

MeshReport reportOf(const Keyframes& keyframes) {
  std::vector<const Positions*> poses;
  for (const Key& key : keyframes.keys) poses.push_back(&key.positions);

  MeshReport report;
  report.vertices = keyframes.vertexCount();
  report.faces = keyframes.faceCount();
  report.diagonal = boundingDiagonal(poses);
  const Welding welding = weld(poses, weldTolerance * report.diagonal);
  report.weldedVertices = welding.count;
  const std::vector<Triangle> faces = weldFaces(keyframes.faces, welding);
  report.counts = countMesh(welding.count, faces);
  report.counts.unreferencedVertices = countMesh(report.vertices, keyframes.faces).unreferencedVertices;
  const std::vector<char> use = facesWithArea(keyframes);
  for (const char used : use) report.degenerateFaces += !used;
  report.components = connectedPieces(dualGraph(welding.count, faces, use), use).count;
  return report;
}

}  // namespace shapespline
