// Separators of graphs with coordinates.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/sparse/graph.h"
#include "core/sparse/minimum_vertex_cut.h"

namespace shapespline {

/// The nodes about the median among which a separator is sought: on either side of it `depth` times the square root of
/// all nodes, which is about a layer of a mesh, but no more than this share of them.
struct Band {
  double depth, share;
};
/// Wider ones shorten separators little (1 % for twice the width) and cost time and balance.
inline constexpr Band separatorBand = {24, 0.18};

/// Divides the nodes into two sides without an edge between them and a small separator: the minimum vertex cut within a
/// band about the median along the longest principal axis, or along another if that one is long. A side may be empty
/// when the graph has no separator to speak of. coordinates: one finite position a node. `onStep` is called twice, at
/// about a third and two thirds of the time.
std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates,
                                const std::function<void()>& onStep = {}, const Band& band = separatorBand);

}  // namespace shapespline
