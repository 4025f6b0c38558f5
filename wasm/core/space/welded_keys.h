// The keys as every space works on them: without copies of vertices, in the mesh's canonical order.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"
#include "core/mesh/input_mesh.h"

namespace shapespline {

struct WeldedKeys {
  InputMesh input;
  WeldedShape shape;
  double diagonal = 0;             ///< the largest of one pose
  std::vector<Vec3> meanPosition;  ///< one per column: of all welded vertices
  /// Of each vertex of the input: those of one group share a normal (weld.h: shadingGroups).
  std::vector<int> shadingGroup;
  int shadingGroups = 0;
};

}  // namespace shapespline
