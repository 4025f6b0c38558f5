// Texture coordinates per corner, as in OBJ and PLY -> per drawn vertex.
#pragma once

#include <array>
#include <vector>

#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// In the file's own sense: origin at the lower left.
using Coordinate = std::array<float, 2>;

/// Sets uvs, seams.copyOf and drawn corners. `ofCorner`: index into `coordinates` for every corner, -1 for none. A
/// vertex takes its first corner's coordinates; corners with different coordinates get a copy, corners without any use
/// the vertex.
void placeCoordinates(PolygonMesh& mesh, const std::vector<Coordinate>& coordinates, const std::vector<int>& ofCorner);

}  // namespace shapespline
