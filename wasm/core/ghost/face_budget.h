// How many of a ghost mesh's faces each component keeps.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"

namespace shapespline {

struct FaceBudget {
  std::vector<int> least;  ///< faces that a component keeps at least; 0 for one that joins its neighbour
  int joined = 0;          ///< number of those
};

/// Half of each component's share of the target by its number of faces, at least a tetrahedron's four, at most what it
/// has; the other half goes where the error is. Where that is more than the target, the components of least area join
/// their neighbours, never the root.
FaceBudget budgetFaces(const WeldedShape& shape, const ShapeTopology& topology, int target);

}  // namespace shapespline
