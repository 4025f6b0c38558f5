// Implicit surface -> closed triangle mesh, by marching tetrahedra.
#pragma once

#include "samples/implicit.h"
#include "samples/surface.h"

namespace shapespline {

/// Triangles of the zero set inside the box, closed and manifold as long as the field is positive on the box's faces.
/// cell: edge of the grid's cubes. The triangles are badly shaped: remesh() them.
Surface polygonise(const Field& field, const Vec3& low, const Vec3& high, double cell);

}  // namespace shapespline
