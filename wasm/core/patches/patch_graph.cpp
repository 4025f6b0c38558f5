#include "core/patches/patch_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace shapespline {

namespace {

// Number of candidates for the central patch.
constexpr int candidates = 64;

double onGrid(double cost) { return std::nearbyint(cost * 0x1p20); }

}  // namespace

PatchGraph::PatchGraph(std::vector<PatchLink> links, std::vector<double> area)
    : links_(std::move(links)), area_(std::move(area)) {
  long long edges = 0, neighbours = 0;
  for (const PatchLink& link : links_)
    if (link.sharedEdges > 0) {
      edges += link.sharedEdges;
      ++neighbours;
    }
  if (neighbours > 0) meanSharedEdges_ = static_cast<double>(edges) / static_cast<double>(neighbours);
  ends_ = compressedRows<End>(patchCount(), [&](auto add) {
    for (int l = 0; l < static_cast<int>(links_.size()); ++l) {
      add(links_[l].from, {l, links_[l].to});
      add(links_[l].to, {l, links_[l].from});
    }
  });
}

void PatchGraph::orient(const PatchTree& tree) {
  std::vector<int> rank(area_.size());
  for (std::size_t i = 0; i < tree.order.size(); ++i) rank[tree.order[i]] = static_cast<int>(i);
  for (PatchLink& link : links_)
    if (link.sharedEdges > 0 && rank[link.from] > rank[link.to]) std::swap(link.from, link.to);
}

// Dijkstra's algorithm if alongPaths, otherwise Prim's. They differ in the key of a patch.
PatchTree PatchGraph::grow(const std::vector<double>& cost, int root, bool alongPaths, std::vector<double>& distance,
                           const Bound& bound) const {
  const int count = patchCount();
  PatchTree tree{{}, std::vector<int>(count, -1), std::vector<int>(count, -1)};
  distance.assign(count, std::numeric_limits<double>::infinity());
  std::vector<char> reached(count, 0);
  bool isWithin = true;
  double sum = 0, unreached = 0;  // weighted distances so far; area that is at least as far as the next patch
  if (bound.reachesAll)
    for (const double a : area_) unreached += a;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reachFrom = [&](int begin) {
    distance[begin] = 0;
    queue.push({0, begin});
    while (isWithin && !queue.empty()) {
      const int patch = queue.top().second;
      queue.pop();
      if (reached[patch]) continue;
      reached[patch] = 1;
      isWithin = !(sum + unreached * distance[patch] > bound.sum);
      sum += area_[patch] * distance[patch];
      unreached -= bound.reachesAll ? area_[patch] : 0;
      tree.order.push_back(patch);
      for (const End& end : ends_.of(patch)) {
        const double there = (alongPaths ? distance[patch] : 0) + cost[end.link];
        if (reached[end.patch] || there >= distance[end.patch]) continue;
        distance[end.patch] = there;
        tree.parent[end.patch] = patch;
        tree.link[end.patch] = end.link;
        queue.push({there, end.patch});
      }
    }
  };
  reachFrom(root);
  for (int patch = 0; patch < count && isWithin; ++patch)
    if (!reached[patch]) reachFrom(patch);
  if (!isWithin) tree.order.clear();
  return tree;
}

PatchTree PatchGraph::centreTree(const std::vector<double>& cost) const {
  std::vector<double> grid, distance;
  for (double c : cost) grid.push_back(std::max(1.0, onGrid(c)));
  const int count = patchCount(), tried = std::min(count, candidates);
  double total = 0, least = std::numeric_limits<double>::infinity();
  for (double a : area_) total += a;
  PatchTree best;
  bool reachesAll = false;
  for (int i = 0; i < tried; ++i) {
    // One extra step, so rounding rejects no equally good tree.
    PatchTree tree = grow(grid, static_cast<int>(static_cast<long long>(i) * count / tried), true, distance,
                          {total * (least + 1), reachesAll});
    if (tree.order.empty()) continue;
    reachesAll = std::count(tree.parent.begin(), tree.parent.end(), -1) == 1;
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += area_[k] / total * distance[k];
    sum = std::nearbyint(sum);
    if (sum < least) {
      least = sum;
      best = std::move(tree);
    }
  }
  return best;
}

PatchTree PatchGraph::spanningTree(const std::vector<double>& weight, int root) const {
  std::vector<double> cost, distance;
  for (double w : weight) cost.push_back(-onGrid(w));
  return grow(cost, root, false, distance, {std::numeric_limits<double>::infinity(), false});
}

}  // namespace shapespline
