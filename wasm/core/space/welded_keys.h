// The keys in the form used by all spaces: without vertex copies, in canonical order.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"
#include "core/mesh/input_mesh.h"

namespace shapespline {

struct WeldedKeys {
  InputMesh input;
  WeldedShape shape;
  double diagonal = 0;             ///< largest bounding diagonal of a pose
  std::vector<Vec3> meanPosition;  ///< per column: mean of all welded vertices
  /// Group of each input vertex. Vertices in a group share a normal (weld.h: shadingGroups).
  std::vector<int> shadingGroup;
  int shadingGroups = 0;
};

}  // namespace shapespline
