// Minimum degree ordering, which has the least fill for small graphs.
#pragma once

#include <vector>

#include "core/sparse/graph.h"

namespace shapespline {

/// Approximate minimum degree (Amestoy, Davis and Duff 1996): order[p] is the node eliminated at position p.
std::vector<int> minimumDegreeOrder(const Graph& graph);

}  // namespace shapespline
