// Minimum vertex cut: the smallest separator inside a band of nodes.
#pragma once

#include <vector>

#include "core/sparse/graph.h"

namespace shapespline {

enum class Side : unsigned char { Left, Right, Separator };

/// Reduces the separator to a minimum subset that still separates Left from Right. The other nodes join a side. No edge
/// may connect Left and Right. Among the minimum separators, the two nearest to either side are considered, and the
/// better balanced one is taken.
///
/// By Menger's theorem, the size of the separator is the largest number of vertex-disjoint paths from Left to Right: a
/// maximum flow with node splitting. Blocking flows (Dinic 1970) find it in few rounds for unit capacities.
void shrinkSeparator(const Graph& graph, std::vector<Side>& side);

}  // namespace shapespline
