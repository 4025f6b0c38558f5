// The elimination tree of a sparse Cholesky factor, and the number of entries in each column.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// The graph renumbered: node p of the result is node order[p] of the input.
Graph permuted(const Graph& graph, const std::vector<int>& order, const FractionReport& onProgress = {});

/// parent[j]: row of the first entry below the diagonal in column j of the factor, -1 for a root (Liu 1986).
/// Nodes are eliminated in the order of their numbers.
std::vector<int> eliminationTree(const Graph& graph, const FractionReport& onProgress = {});

/// Orders the nodes of a forest: children before their parent, every subtree contiguous. order[p] is the node at
/// position p. Siblings keep their order.
std::vector<int> postorder(const std::vector<int>& parent);

/// Number of entries in each column of the factor, including the diagonal (Gilbert, Ng and Peyton 1994).
/// The graph must be numbered in a postorder of its elimination tree.
std::vector<int> factorColumnCounts(const Graph& graph, const std::vector<int>& parent,
                                    const FractionReport& onProgress = {});

}  // namespace shapespline
