// Texture coordinates that belong to corners, as in OBJ and PLY -> to drawn vertices.
#pragma once

#include <array>
#include <vector>

#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// In the file's own sense: origin at the lower left.
using Coordinate = std::array<float, 2>;

/// Sets uvs, seams.copyOf and drawn corners. `ofCorner`: place in `coordinates` of every corner, -1 for none. A vertex
/// takes its first corner's coordinates; corners with other ones get a copy of it, those without any do as the vertex
/// does.
void placeCoordinates(PolygonMesh& mesh, const std::vector<Coordinate>& coordinates, const std::vector<int>& ofCorner);

}  // namespace shapespline
