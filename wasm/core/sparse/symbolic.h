// Supernodal symbolic analysis: finds the columns of the factor that share a dense block, and the rows of each block.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// The structure of a supernodal Cholesky factor. Columns are numbered by elimination position. Supernode s owns the
/// columns first[s] ... first[s + 1] - 1. Below its triangle, it has the rows row[rowStart[s]] ...
/// row[rowStart[s + 1] - 1], ascending. Supernodes are in a postorder of their tree.
struct SymbolicFactor {
  std::vector<int> order;     ///< order[p]: the unknown eliminated at position p
  std::vector<int> position;  ///< inverse of order
  std::vector<int> first = {0};
  std::vector<std::size_t> rowStart = {0};
  std::vector<int> row;
  std::vector<int> parent;  ///< parent of each supernode, -1 for a root

  int size() const { return static_cast<int>(order.size()); }
  int supernodes() const { return static_cast<int>(parent.size()); }
  int columns(int s) const { return first[s + 1] - first[s]; }
  int rows(int s) const { return static_cast<int>(rowStart[s + 1] - rowStart[s]); }
  const int* rowsOf(int s) const { return row.data() + rowStart[s]; }
};

/// Analyses the factor of a matrix with this graph. order: any elimination order. The result's order is equivalent,
/// with the same fill. Supernodes are merged if that saves more than the stored zeros cost. Siblings are ordered for a
/// small update stack (Liu 1986).
SymbolicFactor analyseFactor(const Graph& graph, const std::vector<int>& order, const FractionReport& onProgress = {});

}  // namespace shapespline
