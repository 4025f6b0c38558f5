#include "core/mesh/component_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/coarse_cost.h"
#include "core/mesh/contact.h"
#include "core/mesh/weld.h"

namespace shapespline {

namespace {

// Maximum number of queries for the nearest other component: enough to find the contact, bounded for meshes of many
// components.
constexpr int maximumQueries = 40000;
constexpr int minimumQueriesPerComponent = 4;
// Contacts farther by up to this share, or by the rounding in files, count as equally near. Symmetric shapes have
// several.
constexpr double asNear = 1e-3;

// Vertices of each component that serve as starting points of the search.
std::vector<std::vector<int>> sampleVertices(const std::vector<int>& componentOfVertex, int components) {
  std::vector<std::vector<int>> samples(components);
  for (int v = 0; v < static_cast<int>(componentOfVertex.size()); ++v)
    if (componentOfVertex[v] >= 0) samples[componentOfVertex[v]].push_back(v);
  const int limit = std::max(minimumQueriesPerComponent, maximumQueries / std::max(1, components));
  for (std::vector<int>& list : samples) list = spreadSample(list, limit);
  return samples;
}

struct Edge {
  int a, b;      // component indices
  int atA, atB;  // vertex indices
};

// Boruvka's algorithm: every group joins its nearest other group until one group remains.
std::vector<Edge> spanningEdges(const std::vector<int>& componentOfVertex, int components,
                                std::span<const Positions* const> poses) {
  const auto samples = sampleVertices(componentOfVertex, components);
  const ContactSearch search(poses, componentOfVertex, components);
  const std::vector<double> tolerances = weldTolerances(poses);
  const double rounded = 2 * *std::max_element(tolerances.begin(), tolerances.end());

  std::vector<int> group(components);
  std::iota(group.begin(), group.end(), 0);
  std::vector<Edge> edges;
  while (static_cast<int>(edges.size()) + 1 < components) {
    const std::vector<int> shared = search.sharedLabels(group);
    std::vector<Contact> nearest(components);
    for (int c = 0; c < components; ++c) {
      std::vector<int> lastFound;
      for (int u : samples[c]) search.nearestOther(u, shared, group[c], nearest[group[c]], lastFound);
    }
    // Among equally near contacts, chooses the lowest vertices, so rounding does not decide.
    std::vector<Contact> lowest(components);
    for (int c = 0; c < components; ++c) {
      const int g = group[c];
      const double within = std::pow((1 + asNear) * std::sqrt(nearest[g].distance) + rounded, 2);
      for (int u : samples[c]) {
        if (lowest[g].from >= 0 && lowest[g].from <= u) break;  // samples are in ascending order
        int to = -1;
        search.lowestOther(u, shared, g, within, to);
        if (to >= 0) lowest[g] = {nearest[g].distance, u, to};
      }
    }
    for (int g = 0; g < components; ++g)
      if (lowest[g].from >= 0) nearest[g] = lowest[g];
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

ComponentTree linkComponents(const std::vector<Triangle>& faces, const Components& components,
                             std::span<const Positions* const> poses) {
  ComponentTree tree;
  tree.link.resize(components.count);
  if (components.count == 1) {
    tree.order = {0};
    return tree;
  }
  const std::size_t vertices = poses[0]->size();
  std::vector<int> componentOfVertex(vertices, -1), faceOfVertex(vertices, -1);
  std::vector<double> area(components.count, 0);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    const int c = components.ofFace[f];
    if (c < 0) continue;
    const Triangle& t = faces[f];
    for (const Positions* p : poses) area[c] += ((*p)[t[1]] - (*p)[t[0]]).cross((*p)[t[2]] - (*p)[t[0]]).norm() / 2;
    for (int v : t)
      if (faceOfVertex[v] < 0) {
        componentOfVertex[v] = c;
        faceOfVertex[v] = f;
      }
  }

  const auto smaller = [](double a, double b) { return coarse(a) < coarse(b); };  // coarse, so rounding does not decide
  const int root = static_cast<int>(std::max_element(area.begin(), area.end(), smaller) - area.begin());
  std::vector<std::vector<Edge>> at(components.count);
  for (const Edge& e : spanningEdges(componentOfVertex, components.count, poses)) {
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
