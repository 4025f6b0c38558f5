// Separators of graphs with coordinates.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/sparse/graph.h"
#include "core/sparse/minimum_vertex_cut.h"

namespace shapespline {

/// Divides the nodes into two sides without an edge between them and a small separator: the minimum vertex cut within a
/// band about the median along the longest principal axis, or along another if that one is long. A side may be empty
/// when the graph has no separator to speak of. coordinates: one finite position a node. `onStep` is called twice, at
/// about a third and two thirds of the time.
std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates,
                                const std::function<void()>& onStep = {});

}  // namespace shapespline
