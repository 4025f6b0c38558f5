// Nested dissection (George 1973) on coordinates.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// Elimination order: order[p] is the node at position p. Graph halves come first, their separator last, recursively;
/// small subgraphs are ordered by minimum degree among all their neighbours. coordinates: one finite position a node.
std::vector<int> nestedDissectionOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                       const FractionReport& onProgress = {});

}  // namespace shapespline
