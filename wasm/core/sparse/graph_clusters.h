// Coarse graph of node clusters.
#pragma once

#include <vector>

#include "core/sparse/graph.h"

namespace shapespline {

struct GraphClusters {
  std::vector<int> ofNode;  ///< cluster of each node
  Graph graph;              ///< graph of the clusters, with an edge where their nodes are adjacent
};

/// In ascending order, each node without clustered neighbours forms a cluster with all its neighbours. Each remaining
/// node joins the cluster of its first clustered neighbour. A cluster of a triangle mesh has about eight nodes
/// (aggregation, as in algebraic multigrid: Vanek, Mandel and Brezina 1996).
GraphClusters clusterNodes(const Graph& graph);

}  // namespace shapespline
