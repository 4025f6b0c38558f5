#include "core/sparse/nested_dissection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

#include "core/base/sort_indices.h"
#include "core/sparse/graph_clusters.h"
#include "core/sparse/minimum_degree.h"
#include "core/sparse/separator.h"

namespace shapespline {

namespace {

constexpr int leafSize = 64;
// A larger share of nodes in a separator means that the graph is not a mesh, so minimum degree works better.
constexpr double uselessSeparator = 0.3;
// Larger subgraphs are first divided by clusters, because a wide band of nodes would be costly.
constexpr int manyNodes = 3000;
constexpr Band bandOfClusters = {60, 0.3};
// Number of cluster layers on either side of the clusters' separator for the search among nodes.
constexpr int nearbyLayers = 2;

// A subgraph of nodes or of clusters, compactly renumbered.
struct Subgraph {
  Graph graph;
  std::vector<Vec3> coordinates;
  std::vector<int> original;
};

using Counts = std::array<int, 3>;

Counts countSides(const std::vector<Side>& side) {
  Counts count = {0, 0, 0};
  for (Side s : side) ++count[static_cast<int>(s)];
  return count;
}

bool isUseful(const Counts& count) {
  const int size = count[0] + count[1] + count[2];
  return count[0] > 0 && count[1] > 0 && count[2] <= uselessSeparator * size;
}

// The separator and its adjacent nodes.
std::vector<Side> widened(const Graph& graph, const std::vector<Side>& side) {
  std::vector<Side> wide = side;
  for (int v = 0; v < graph.size(); ++v)
    if (side[v] == Side::Separator)
      for (const int u : graph.neighbours(v)) wide[u] = Side::Separator;
  return wide;
}

class Dissection {
 public:
  Dissection(const Graph& graph, std::span<const Vec3> coordinates, const FractionReport& onProgress)
      : whole_(graph),
        clusters_(clusterNodes(graph)),
        onProgress_(onProgress),
        local_(graph.size(), -1),
        number_(graph.size()),
        clusterNumber_(clusters_.graph.size(), -1) {
    order_.resize(graph.size());
    Subgraph subgraph{graph, {coordinates.begin(), coordinates.end()}, std::vector<int>(graph.size())};
    std::iota(subgraph.original.begin(), subgraph.original.end(), 0);
    end_ = graph.size();
    dissect(std::move(subgraph));
  }

  std::vector<int> takeOrder() { return std::move(order_); }

 private:
  // Fills the order from its end: the separator, then the right side, then the left side.
  void dissect(Subgraph subgraph) {
    const int size = subgraph.graph.size();
    if (size <= leafSize) return orderLeaf(subgraph.original);
    reportWork(size);
    const std::vector<Side> side = sidesOf(subgraph);
    const Counts count = countSides(side);
    reportWork(0.4 * size);
    if (!isUseful(count)) return orderByDegree(subgraph);
    placeSeparator(subgraph, side);
    auto [left, right] = divide(subgraph, side, count);
    subgraph = {};
    dissect(std::move(right));
    dissect(std::move(left));
  }

  std::vector<Side> sidesOf(const Subgraph& subgraph) {
    const double step = 0.3 * subgraph.graph.size();
    const auto onStep = [&] { reportWork(step); };
    if (subgraph.graph.size() > manyNodes) {
      std::vector<Side> side = sidesByClusters(subgraph, onStep);
      if (isUseful(countSides(side))) return side;
    }
    return findSeparator(subgraph.graph, subgraph.coordinates, onStep);
  }

  // Finds a separator of the subgraph's clusters, then the smallest separator of nodes near it. Empty for few clusters.
  std::vector<Side> sidesByClusters(const Subgraph& subgraph, const std::function<void()>& onStep) {
    const Subgraph clusters = clustersOf(subgraph);
    std::vector<Side> side;
    if (clusters.graph.size() > leafSize) {
      std::vector<Side> near = findSeparator(clusters.graph, clusters.coordinates, onStep, bandOfClusters);
      for (int layer = 0; layer < nearbyLayers; ++layer) near = widened(clusters.graph, near);
      side.reserve(subgraph.original.size());
      for (const int v : subgraph.original) side.push_back(near[clusterNumber_[clusters_.ofNode[v]]]);
      shrinkSeparator(subgraph.graph, side);
    }
    for (const int c : clusters.original) clusterNumber_[c] = -1;
    return side;
  }

  // Numbers the clusters. Each cluster is at the position of its first node.
  Subgraph clustersOf(const Subgraph& subgraph) {
    Subgraph clusters;
    for (std::size_t i = 0; i < subgraph.original.size(); ++i) {
      const int c = clusters_.ofNode[subgraph.original[i]];
      if (clusterNumber_[c] >= 0) continue;
      clusterNumber_[c] = static_cast<int>(clusters.original.size());
      clusters.original.push_back(c);
      clusters.coordinates.push_back(subgraph.coordinates[i]);
    }
    for (const int c : clusters.original) {
      for (const int other : clusters_.graph.neighbours(c))
        if (clusterNumber_[other] >= 0) clusters.graph.neighbour.push_back(clusterNumber_[other]);
      clusters.graph.start.push_back(static_cast<int>(clusters.graph.neighbour.size()));
    }
    return clusters;
  }

  // Every node is divided about as often as subgraphs can be halved, in two steps each: finding and extracting.
  void reportWork(double nodes) {
    const double halvings = std::max(1.0, std::log2(static_cast<double>(whole_.size()) / leafSize));
    work_ += nodes / (2 * halvings * whole_.size());
    if (work_ < reported_ + 0.01) return;
    reported_ = std::min(1.0, work_);
    reportFraction(onProgress_, reported_);
  }

  // Orders the separator along its longest axis, so its rows in a neighbouring block are contiguous.
  void placeSeparator(const Subgraph& subgraph, const std::vector<Side>& side) {
    std::vector<int> nodes;
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (int v = 0; v < subgraph.graph.size(); ++v) {
      if (side[v] != Side::Separator) continue;
      nodes.push_back(v);
      low = low.cwiseMin(subgraph.coordinates[v]);
      high = high.cwiseMax(subgraph.coordinates[v]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    sortIndices(nodes, [&](int a, int b) {
      return std::pair(subgraph.coordinates[a][axis], a) < std::pair(subgraph.coordinates[b][axis], b);
    });
    end_ -= static_cast<int>(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) order_[end_ + static_cast<int>(i)] = subgraph.original[nodes[i]];
  }

  // The left and right sides.
  std::array<Subgraph, 2> divide(const Subgraph& subgraph, const std::vector<Side>& side, const Counts& count) {
    const Graph& graph = subgraph.graph;
    std::array<Subgraph, 2> halves;
    std::array<std::size_t, 2> ends = {0, 0};  // upper bound for the number of edge ends
    for (int h = 0; h < 2; ++h) {
      halves[h].original.reserve(count[h]);
      halves[h].coordinates.reserve(count[h]);
      halves[h].graph.start.reserve(count[h] + 1);
    }
    for (int v = 0; v < graph.size(); ++v) {
      if (side[v] == Side::Separator) continue;
      Subgraph& half = halves[static_cast<int>(side[v])];
      number_[v] = static_cast<int>(half.original.size());
      half.original.push_back(subgraph.original[v]);
      half.coordinates.push_back(subgraph.coordinates[v]);
      ends[static_cast<int>(side[v])] += graph.degree(v);
    }
    for (int h = 0; h < 2; ++h) halves[h].graph.neighbour.reserve(ends[h]);
    for (int v = 0; v < graph.size(); ++v) {
      if (side[v] == Side::Separator) continue;
      Graph& half = halves[static_cast<int>(side[v])].graph;
      for (const int u : graph.neighbours(v))
        if (side[u] == side[v]) half.neighbour.push_back(number_[u]);
      half.start.push_back(static_cast<int>(half.neighbour.size()));
    }
    return halves;
  }

  void orderByDegree(const Subgraph& subgraph) {
    const std::vector<int> order = minimumDegreeOrder(subgraph.graph);
    end_ -= subgraph.graph.size();
    for (std::size_t i = 0; i < order.size(); ++i) order_[end_ + static_cast<int>(i)] = subgraph.original[order[i]];
  }

  // Minimum degree on bit sets. Neighbours outside the leaf are eliminated later but count for the degrees.
  void orderLeaf(const std::vector<int>& nodes) {
    using Bits = std::array<std::uint64_t, 4>;
    constexpr int bitCount = 256;
    const int size = static_cast<int>(nodes.size());
    const auto degree = [](const Bits& bits) {
      int sum = 0;
      for (std::uint64_t word : bits) sum += std::popcount(word);
      return sum;
    };
    std::array<Bits, leafSize> adjacent = {};
    std::array<int, leafSize> degrees = {};
    halo_.clear();
    for (int v = 0; v < size; ++v) local_[nodes[v]] = v;
    for (int v = 0; v < size; ++v) {
      for (int u : whole_.neighbours(nodes[v])) {
        if (local_[u] == -1 && size + static_cast<int>(halo_.size()) < bitCount) {
          local_[u] = size + static_cast<int>(halo_.size());
          halo_.push_back(u);
        }
        if (local_[u] != -1) adjacent[v][local_[u] / 64] |= std::uint64_t{1} << (local_[u] % 64);
      }
      degrees[v] = degree(adjacent[v]);
    }
    for (int u : halo_) local_[u] = -1;
    for (int v = 0; v < size; ++v) local_[nodes[v]] = -1;

    end_ -= size;
    constexpr int gone = 1 << 30;
    for (int i = 0; i < size; ++i) {
      const int v = static_cast<int>(std::min_element(degrees.begin(), degrees.begin() + size) - degrees.begin());
      order_[end_ + i] = nodes[v];
      degrees[v] = gone;
      const Bits clique = adjacent[v];
      for (int word = 0; word < 4; ++word) {
        for (std::uint64_t rest = clique[word]; rest != 0; rest &= rest - 1) {
          const int u = 64 * word + std::countr_zero(rest);
          if (u >= size) break;
          for (int k = 0; k < 4; ++k) adjacent[u][k] |= clique[k];
          adjacent[u][u / 64] &= ~(std::uint64_t{1} << (u % 64));
          adjacent[u][v / 64] &= ~(std::uint64_t{1} << (v % 64));
          degrees[u] = degree(adjacent[u]);
        }
      }
    }
  }

  const Graph& whole_;
  const GraphClusters clusters_;
  const FractionReport& onProgress_;
  double work_ = 0, reported_ = 0;
  std::vector<int> local_;          // local number of a leaf's nodes and their neighbours during its ordering, else -1
  std::vector<int> number_;         // number of a subgraph's nodes in their side, during division
  std::vector<int> clusterNumber_;  // number of each cluster in a subgraph during division, else -1
  std::vector<int> halo_;
  std::vector<int> order_;
  int end_ = 0;  // start of the filled part of order_
};

}  // namespace

std::vector<int> nestedDissectionOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                       const FractionReport& onProgress) {
  return Dissection(graph, coordinates, onProgress).takeOrder();
}

}  // namespace shapespline
