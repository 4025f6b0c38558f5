// Minimum vertex cuts: the smallest separator inside a band of nodes.
#pragma once

#include <vector>

#include "core/sparse/graph.h"

namespace shapespline {

enum class Side : unsigned char { Left, Right, Separator };

/// Replaces the separator by a smallest part of it that still separates what is Left from what is Right; its other
/// nodes join a side. No edge may join the two sides. Of the smallest separators it takes the one nearest to either
/// side that leaves the better balance.
///
/// By Menger's theorem their size is the largest number of vertex-disjoint paths from Left to Right: a maximum flow
/// with node splitting, found by blocking flows (Dinic 1970), which for unit capacities takes few rounds.
void shrinkSeparator(const Graph& graph, std::vector<Side>& side);

}  // namespace shapespline
