#include "core/sparse/graph_clusters.h"

#include <algorithm>

#include "core/base/compressed_rows.h"

namespace shapespline {

namespace {

constexpr int unclustered = -1;

// Returns the number of clusters.
int growClusters(const Graph& graph, std::vector<int>& ofNode) {
  const auto isClustered = [&](int v) { return ofNode[v] != unclustered; };
  ofNode.assign(graph.size(), unclustered);
  int count = 0;
  for (int v = 0; v < graph.size(); ++v) {
    const auto neighbours = graph.neighbours(v);
    if (isClustered(v) || std::any_of(neighbours.begin(), neighbours.end(), isClustered)) continue;
    ofNode[v] = count;
    for (const int u : neighbours) ofNode[u] = count;
    ++count;
  }
  const std::vector<int> grown = ofNode;
  for (int v = 0; v < graph.size(); ++v)
    for (const int u : graph.neighbours(v)) {
      if (ofNode[v] != unclustered) break;
      ofNode[v] = grown[u];
    }
  return count;
}

}  // namespace

GraphClusters clusterNodes(const Graph& graph) {
  GraphClusters clusters;
  const int count = growClusters(graph, clusters.ofNode);
  const auto members = compressedRows<int>(count, [&](auto add) {
    for (int v = 0; v < graph.size(); ++v) add(clusters.ofNode[v], v);
  });
  std::vector<int> seenFrom(count, unclustered);
  for (int c = 0; c < count; ++c) {
    seenFrom[c] = c;
    for (const int v : members.of(c))
      for (const int u : graph.neighbours(v)) {
        const int other = clusters.ofNode[u];
        if (seenFrom[other] == c) continue;
        seenFrom[other] = c;
        clusters.graph.neighbour.push_back(other);
      }
    std::sort(clusters.graph.neighbour.begin() + clusters.graph.start.back(), clusters.graph.neighbour.end());
    clusters.graph.start.push_back(static_cast<int>(clusters.graph.neighbour.size()));
  }
  return clusters;
}

}  // namespace shapespline
