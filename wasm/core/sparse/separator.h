// Separators of graphs with coordinates.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/sparse/graph.h"
#include "core/sparse/minimum_vertex_cut.h"

namespace shapespline {

/// The nodes around the median that may form the separator: on either side `depth` times the square root of all nodes,
/// about `depth` layers of a mesh, but at most this share of all nodes.
struct Band {
  double depth, share;
};
/// Wider bands shorten separators little (1 % for twice the width) and cost time and balance.
inline constexpr Band separatorBand = {24, 0.18};

/// Divides the nodes into two sides without a connecting edge, and a small separator: the minimum vertex cut within a
/// band around the median along the longest principal axis, or along another axis if the first cut is long. A side may
/// be empty if the graph has no useful separator. coordinates: one finite position per node. `onStep` is called twice,
/// after about one third and two thirds of the time.
std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates,
                                const std::function<void()>& onStep = {}, const Band& band = separatorBand);

}  // namespace shapespline
