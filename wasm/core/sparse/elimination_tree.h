// The elimination tree of a sparse Cholesky factor and the number of entries in each of its columns.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// The graph renumbered: node p of the result is node order[p] of the input.
Graph permuted(const Graph& graph, const std::vector<int>& order, const FractionReport& onProgress = {});

/// parent[j]: the row of the first entry below the diagonal in column j of the factor, -1 for a root (Liu 1986).
/// The graph's nodes are eliminated in the order of their numbers.
std::vector<int> eliminationTree(const Graph& graph, const FractionReport& onProgress = {});

/// The nodes of a forest, children before their parent, every subtree contiguous; order[p] is the node at position p.
/// Siblings keep the order of their numbers.
std::vector<int> postorder(const std::vector<int>& parent);

/// Entries of each column of the factor, diagonal included (Gilbert, Ng and Peyton 1994).
/// The graph must be numbered in a postorder of its elimination tree.
std::vector<int> factorColumnCounts(const Graph& graph, const std::vector<int>& parent,
                                    const FractionReport& onProgress = {});

}  // namespace shapespline
