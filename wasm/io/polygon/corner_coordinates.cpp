#include "io/polygon/corner_coordinates.h"

#include <algorithm>
#include <tuple>

#include "core/base/sort_indices.h"

namespace shapespline {

namespace {

void setCoordinate(std::vector<float>& uvs, std::size_t vertex, const Coordinate& coordinate) {
  uvs[2 * vertex] = coordinate[0];
  uvs[2 * vertex + 1] = 1 - coordinate[1];
}

}  // namespace

void placeCoordinates(PolygonMesh& mesh, const std::vector<Coordinate>& coordinates, const std::vector<int>& ofCorner) {
  const std::size_t n = mesh.positions.size();
  std::vector<float>& uvs = mesh.scene.uvs;
  uvs.assign(2 * n, 0);
  std::vector<int> ofVertex(n, -1), apart;  // corners whose coordinates differ from their vertex's
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    if (ofCorner[c] < 0) continue;
    int& own = ofVertex[mesh.corners[c]];
    if (own < 0) setCoordinate(uvs, mesh.corners[c], coordinates[own = ofCorner[c]]);
    else if (coordinates[own] != coordinates[ofCorner[c]]) apart.push_back(static_cast<int>(c));
  }
  if (apart.empty()) return;

  // Makes corners with the same copy adjacent. Copies are numbered in vertex order.
  const auto place = [&](int c) { return std::tie(mesh.corners[c], coordinates[ofCorner[c]]); };
  sortIndices(apart, [&](int a, int b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  mesh.drawn = mesh.corners;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (i == 0 || place(apart[i]) != place(apart[i - 1])) {
      mesh.scene.seams.copyOf.push_back(mesh.corners[apart[i]]);
      uvs.resize(uvs.size() + 2);
      setCoordinate(uvs, uvs.size() / 2 - 1, coordinates[ofCorner[apart[i]]]);
    }
    mesh.drawn[apart[i]] = static_cast<int>(uvs.size() / 2 - 1);
  }
}

}  // namespace shapespline
