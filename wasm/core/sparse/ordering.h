// Fill-reducing elimination orders.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/sparse/graph.h"

namespace shapespline {

/// The solver's order: nested dissection for large graphs with coordinates, otherwise minimum degree.
/// coordinates: one position per node, or empty.
std::vector<int> fillReducingOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                   const FractionReport& onProgress = {});

}  // namespace shapespline
