#include "core/component_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/kd_tree.h"

namespace shapespline {

namespace {

// Queries for the nearest other component: enough to find the place of contact, bounded for meshes of many pieces.
constexpr int maximumQueries = 40000;
constexpr int minimumQueriesPerComponent = 4;
// Distances are measured in every pose, but searched from this many only.
constexpr int searchedPoses = 4;

struct Contact {
  double distance = std::numeric_limits<double>::infinity();
  int from = -1, to = -1;  // vertices
};

// Vertices of each component that are used as starting points of the search.
std::vector<std::vector<int>> sampleVertices(const std::vector<int>& componentOfVertex, int components) {
  std::vector<std::vector<int>> samples(components);
  for (int v = 0; v < static_cast<int>(componentOfVertex.size()); ++v)
    if (componentOfVertex[v] >= 0) samples[componentOfVertex[v]].push_back(v);
  const int limit = std::max(minimumQueriesPerComponent, maximumQueries / std::max(1, components));
  for (std::vector<int>& list : samples) {
    const int size = static_cast<int>(list.size());
    if (size <= limit) continue;
    std::vector<int> kept(limit);
    for (int i = 0; i < limit; ++i) kept[i] = list[static_cast<std::int64_t>(i) * size / limit];
    list = std::move(kept);
  }
  return samples;
}

std::vector<int> evenlyChosen(int count, int wanted) {
  std::vector<int> chosen;
  const int take = std::min(count, wanted);
  for (int i = 0; i < take; ++i) chosen.push_back(take == 1 ? 0 : i * (count - 1) / (take - 1));
  return chosen;
}

struct Edge {
  int a, b;        // components
  int atA, atB;    // vertices
};

// Boruvka's algorithm: every group joins its nearest other group until one is left.
std::vector<Edge> spanningEdges(const std::vector<int>& componentOfVertex, int components,
                                std::span<const Positions* const> poses) {
  std::vector<int> used;
  for (int v = 0; v < static_cast<int>(componentOfVertex.size()); ++v)
    if (componentOfVertex[v] >= 0) used.push_back(v);
  const auto samples = sampleVertices(componentOfVertex, components);
  std::vector<KdTree> trees;
  std::vector<const Positions*> searched;
  for (int pose : evenlyChosen(static_cast<int>(poses.size()), searchedPoses)) {
    trees.emplace_back(*poses[pose], used);
    searched.push_back(poses[pose]);
  }
  const auto distance = [&](int u, int v) {
    double largest = 0;
    for (const Positions* p : poses) largest = std::max(largest, ((*p)[u] - (*p)[v]).squaredNorm());
    return largest;
  };

  std::vector<int> group(components);
  std::iota(group.begin(), group.end(), 0);
  std::vector<Edge> edges;
  while (static_cast<int>(edges.size()) + 1 < components) {
    const auto groupOf = [&](int v) { return group[componentOfVertex[v]]; };
    std::vector<std::vector<int>> shared;
    for (const KdTree& tree : trees) shared.push_back(tree.sharedLabels(groupOf));
    std::vector<Contact> nearest(components);
    for (int c = 0; c < components; ++c)
      for (int u : samples[c])
        for (std::size_t k = 0; k < trees.size(); ++k) {
          // The distance is the largest of all poses: what is no nearer in this one is no nearer.
          Contact& best = nearest[group[c]];
          const int v = trees[k].nearestOther((*searched[k])[u], groupOf, shared[k], group[c], best.distance);
          if (v < 0) continue;
          const double d = distance(u, v);
          if (d < best.distance) best = {d, u, v};
        }
    bool joined = false;
    for (int g = 0; g < components; ++g) {
      if (nearest[g].from < 0) continue;
      const int a = componentOfVertex[nearest[g].from], b = componentOfVertex[nearest[g].to];
      if (group[a] == group[b]) continue;
      edges.push_back({a, b, nearest[g].from, nearest[g].to});
      const int keep = group[a], gone = group[b];
      for (int& x : group)
        if (x == gone) x = keep;
      joined = true;
    }
    if (!joined) break;
  }
  return edges;
}

}  // namespace

ComponentTree linkComponents(const std::vector<Triangle>& faces, const Pieces& pieces,
                             std::span<const Positions* const> poses) {
  ComponentTree tree;
  tree.link.resize(pieces.count);
  if (pieces.count == 1) {
    tree.order = {0};
    return tree;
  }
  const Positions& first = *poses[0];
  std::vector<int> componentOfVertex(first.size(), -1), faceOfVertex(first.size(), -1);
  std::vector<double> area(pieces.count, 0);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    const int c = pieces.ofFace[f];
    if (c < 0) continue;
    const Triangle& t = faces[f];
    area[c] += (first[t[1]] - first[t[0]]).cross(first[t[2]] - first[t[0]]).norm() / 2;
    for (int v : t)
      if (faceOfVertex[v] < 0) componentOfVertex[v] = c, faceOfVertex[v] = f;
  }

  const int root = static_cast<int>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<std::vector<Edge>> at(pieces.count);
  for (const Edge& e : spanningEdges(componentOfVertex, pieces.count, poses)) {
    at[e.a].push_back(e);
    at[e.b].push_back({e.b, e.a, e.atB, e.atA});
  }
  tree.order.push_back(root);
  for (std::size_t i = 0; i < tree.order.size(); ++i) {
    const int parent = tree.order[i];
    for (const Edge& e : at[parent]) {
      if (e.b == tree.link[parent].parent) continue;
      tree.link[e.b] = {parent, faceOfVertex[e.atA], faceOfVertex[e.atB]};
      tree.order.push_back(e.b);
    }
  }
  return tree;
}

}  // namespace shapespline
