// Divides a ghost mesh's faces among the components.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"

namespace shapespline {

struct FaceBudget {
  std::vector<int> least;  ///< minimum number of faces of each component; 0 for one that joins its neighbour
  int joined = 0;          ///< number of joining components
};

/// The minimum of a component is half of its share of the target (by number of faces), at least four faces (a
/// tetrahedron), at most all its faces. The other half of the target goes to components with the largest error. If the
/// minima exceed the target, components with the smallest area join their neighbours. The root never joins.
FaceBudget budgetFaces(const WeldedShape& shape, const ShapeTopology& topology, int target);

}  // namespace shapespline
