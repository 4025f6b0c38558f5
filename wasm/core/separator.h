// Vertex separators of graphs with coordinates: a planar cut, a minimum vertex cover of its edges, local refinement.
#pragma once

#include <span>
#include <vector>

#include "core/graph.h"
#include "core/types.h"

namespace shapespline {

enum class Side : unsigned char { Left, Right, Separator };

/// Divides the nodes into two sides without an edge between them and a small separator. Both sides are near half of
/// the nodes; either may be empty when the graph has no separator to speak of. coordinates: one finite position a node.
std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates);

/// Improves a separator in place by Fiduccia-Mattheyses passes (moves of single nodes, best prefix kept). No edge may join the
/// two sides. A side may grow to (1/2 + slack) of the nodes.
void refineSeparator(const Graph& graph, std::vector<Side>& side, double slack);

}  // namespace shapespline
