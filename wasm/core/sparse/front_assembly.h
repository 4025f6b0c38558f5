// Destinations of the numbers that form the fronts, computed once per matrix structure.
#pragma once

#include <cstddef>
#include <vector>

#include "core/sparse/sparse_matrix.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

/// A front is the sum of matrix entries and its children's update matrices. Both can be added without the unknowns'
/// numbers.
struct Assembly {
  std::vector<int> slot;            ///< slot of each matrix value; slots are sorted by supernode
  std::vector<int> start;           ///< slots of supernode s: start[s] ... start[s + 1] - 1
  std::vector<std::size_t> target;  ///< position of each slot's value in the columns of the front (see dense_front.h)
  std::vector<int> parentRow;       ///< row of the parent's front for row i of symbolic.row
};

Assembly planAssembly(const SymmetricMatrix& matrix, const SymbolicFactor& symbolic);

}  // namespace shapespline
