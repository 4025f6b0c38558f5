// Converts texture coordinates per corner, as in OBJ and PLY, to coordinates per drawn vertex.
#pragma once

#include <array>
#include <vector>

#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// In file order: origin at the lower left.
using Coordinate = std::array<float, 2>;

/// Sets uvs, seams.copyOf and drawn corners. `ofCorner`: index into `coordinates` for every corner, or -1. A vertex
/// takes its first corner's coordinates. Corners with different coordinates get a copy, and corners without coordinates
/// use the vertex.
void placeCoordinates(PolygonMesh& mesh, const std::vector<Coordinate>& coordinates, const std::vector<int>& ofCorner);

}  // namespace shapespline
