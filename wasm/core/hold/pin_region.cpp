#include "core/hold/pin_region.h"

#include <algorithm>

#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

// Marks the patch of the first face at the vertex.
std::vector<char> inPatchOf(const HoldInput& input, int vertex) {
  std::vector<char> in(input.mesh.shape.vertexCount(), 0);
  const std::vector<Triangle>& faces = input.mesh.shape.faces;
  int patch = -1;
  for (std::size_t f = 0; f < faces.size() && patch < 0; ++f)
    if (std::count(faces[f].begin(), faces[f].end(), vertex) > 0) patch = input.patchOfFace[f];
  for (std::size_t f = 0; f < faces.size() && patch >= 0; ++f)
    if (input.patchOfFace[f] == patch)
      for (const int v : faces[f]) in[v] = 1;
  return in;
}

// Grows over faces, to exclude other limbs inside the ball.
std::vector<char> inBallAround(const WeldedShape& shape, int vertex, double radius) {
  const Positions& p = shape.poses[shape.reference];
  const VertexFaces facesAt = facesOfVertices(shape.vertexCount(), shape.faces);
  std::vector<char> in(p.size(), 0);
  std::vector<int> found = {vertex};
  in[vertex] = 1;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const int f : facesAt.of(found[i]))
      for (const int v : shape.faces[f])
        if (!in[v] && (p[v] - p[vertex]).norm() <= radius) {
          in[v] = 1;
          found.push_back(v);
        }
  return in;
}

}  // namespace

std::vector<int> pinnedVertices(const HoldInput& input, int vertex, double radius) {
  const WeldedShape& shape = input.mesh.shape;
  std::vector<char> in = radius > 0 ? inBallAround(shape, vertex, radius * sizeOf(shape.poses[shape.reference]))
                                    : inPatchOf(input, vertex);
  in[vertex] = 1;
  std::vector<int> vertices;
  for (int v = 0; v < shape.vertexCount(); ++v)
    if (in[v]) vertices.push_back(v);
  return vertices;
}

}  // namespace shapespline
