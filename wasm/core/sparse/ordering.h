// Fill-reducing elimination orders.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// The order the solver uses: nested dissection for large graphs with coordinates, else minimum degree.
/// coordinates: one position a node, or empty.
std::vector<int> fillReducingOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                   const FractionReport& onProgress = {});

}  // namespace shapespline
