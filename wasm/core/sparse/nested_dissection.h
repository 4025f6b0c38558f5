// Nested dissection (George 1973) with coordinates.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// Elimination order: order[p] is the node at position p. The halves of the graph come first, their separator last,
/// recursively. Small subgraphs are ordered by minimum degree, including neighbours outside. coordinates: one finite
/// position per node.
std::vector<int> nestedDissectionOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                       const FractionReport& onProgress = {});

}  // namespace shapespline
