// A graph in the small: its clusters.
#pragma once

#include <vector>

#include "core/sparse/graph.h"

namespace shapespline {

struct GraphClusters {
  std::vector<int> ofNode;  ///< cluster of each node
  Graph graph;              ///< of the clusters: an edge where one joins nodes of theirs
};

/// In ascending order each node without clustered neighbours makes a cluster with all of these; what is left over joins
/// that of its first clustered neighbour. A cluster of a triangle mesh's nodes has about eight (aggregation, as in
/// algebraic multigrid: Vanek, Mandel and Brezina 1996).
GraphClusters clusterNodes(const Graph& graph);

}  // namespace shapespline
