// Where the numbers that fronts are assembled from go: found once for all matrices of one structure.
#pragma once

#include <cstddef>
#include <vector>

#include "core/sparse/sparse_matrix.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

/// What a front is the sum of: entries of the matrix, and its children's update matrices. Neither needs the numbers of
/// unknowns.
struct Assembly {
  std::vector<int> slot;   ///< of each of the matrix's values, which in order of their slots are sorted by supernode
  std::vector<int> start;  ///< slots of supernode s: start[s] ... start[s + 1] - 1
  std::vector<std::size_t> target;  ///< of each slot's value in the columns of the front (see dense_front.h)
  std::vector<int> parentRow;       ///< row i of symbolic.row is this row of its parent's front
};

Assembly planAssembly(const SymmetricMatrix& matrix, const SymbolicFactor& symbolic);

}  // namespace shapespline
