// Compares orderings and the symbolic analysis with brute force on small graphs, and checks their quality on a mesh.
#include "core/sparse/ordering.h"
#include "core/sparse/minimum_degree.h"

#include <doctest/doctest.h>

#include <bit>
#include <set>

#include "core/sparse/elimination_tree.h"
#include "core/sparse/graph_clusters.h"
#include "core/sparse/nested_dissection.h"
#include "core/sparse/separator.h"
#include "core/sparse/symbolic.h"
#include "laplacian_meshes.h"

namespace shapespline::test::ordering_test {

namespace {

Graph graphFromEdges(int size, const std::vector<std::pair<int, int>>& edges) {
  std::vector<Triplet> triplets;
  for (auto [a, b] : edges) triplets.push_back({std::max(a, b), std::min(a, b), 1.0});
  return graphOf(assembleSymmetric(size, triplets));
}

Graph randomGraph(int size, int edgeCount, Random& random) {
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < edgeCount; ++i) edges.emplace_back(random.below(size), random.below(size));
  return graphFromEdges(size, edges);
}

Graph meshGraph(const PlainMesh& mesh) { return graphOf(pinnedLaplacian(mesh)); }

std::vector<Vec3> randomPoints(int size, Random& random) {
  std::vector<Vec3> points(size);
  for (Vec3& p : points) p = Vec3(random.signedUnit(), random.signedUnit(), random.signedUnit());
  return points;
}

bool isPermutation(std::vector<int> order, int size) {
  std::sort(order.begin(), order.end());
  for (int i = 0; i < size; ++i)
    if (i >= static_cast<int>(order.size()) || order[i] != i) return false;
  return static_cast<int>(order.size()) == size;
}

// Rows below the diagonal in each column of the factor, by elimination.
std::vector<std::set<int>> eliminate(const Graph& graph) {
  std::vector<std::set<int>> below(graph.size());
  for (int v = 0; v < graph.size(); ++v)
    for (int u : graph.neighbours(v))
      if (u > v) below[v].insert(u);
  for (const std::set<int>& clique : below)
    for (auto a = clique.begin(); a != clique.end(); ++a) below[*a].insert(std::next(a), clique.end());
  return below;
}

std::int64_t factorEntries(const Graph& graph, const std::vector<int>& order) {
  const Graph ordered = permuted(graph, order);
  const std::vector<int> parent = eliminationTree(ordered), post = postorder(parent);
  std::vector<int> composed(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) composed[p] = order[post[p]];
  const Graph postordered = permuted(graph, composed);
  std::int64_t sum = 0;
  for (int count : factorColumnCounts(postordered, eliminationTree(postordered))) sum += count;
  return sum;
}

bool separates(const Graph& graph, const std::vector<Side>& side) {
  for (int v = 0; v < graph.size(); ++v)
    for (int u : graph.neighbours(v))
      if (side[v] != Side::Separator && side[u] != Side::Separator && side[u] != side[v]) return false;
  return true;
}

std::array<int, 3> sizes(const std::vector<Side>& side) {
  std::array<int, 3> count = {0, 0, 0};
  for (Side s : side) ++count[static_cast<int>(s)];
  return count;
}

}  // namespace

TEST_CASE("ordering: elimination tree and column counts agree with elimination by hand") {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const int size = 1 + random.below(40);
    const Graph graph = randomGraph(size, random.below(3 * size), random);
    const std::vector<int> post = postorder(eliminationTree(graph));
    REQUIRE(isPermutation(post, size));
    const Graph ordered = permuted(graph, post);
    const std::vector<int> parent = eliminationTree(ordered), count = factorColumnCounts(ordered, parent);
    const std::vector<std::set<int>> below = eliminate(ordered);
    for (int v = 0; v < size; ++v) {
      CHECK(parent[v] == (below[v].empty() ? -1 : *below[v].begin()));
      CHECK(count[v] == static_cast<int>(below[v].size()) + 1);
    }
  }
}

TEST_CASE("ordering: the symbolic factor covers all fill") {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    const int size = 1 + random.below(60);
    const Graph graph = randomGraph(size, random.below(3 * size), random);
    const SymbolicFactor factor = analyseFactor(graph, minimumDegreeOrder(graph));
    REQUIRE(isPermutation(factor.order, size));
    REQUIRE(factor.first.back() == size);
    const std::vector<std::set<int>> below = eliminate(permuted(graph, factor.order));
    for (int s = 0; s < factor.supernodes(); ++s) {
      const std::set<int> rows(factor.rowsOf(s), factor.rowsOf(s) + factor.rows(s));
      CHECK(std::is_sorted(factor.rowsOf(s), factor.rowsOf(s) + factor.rows(s)));
      CHECK(static_cast<int>(rows.size()) == factor.rows(s));
      for (int p = factor.first[s]; p < factor.first[s + 1]; ++p) {
        CHECK(factor.position[factor.order[p]] == p);
        for (int r : below[p]) CHECK((r < factor.first[s + 1] || rows.count(r) == 1));
      }
      // The update matrix must fit into the parent's front.
      if (factor.parent[s] == -1) {
        CHECK(rows.empty());
      } else {
        const int parent = factor.parent[s];
        const std::set<int> above(factor.rowsOf(parent), factor.rowsOf(parent) + factor.rows(parent));
        REQUIRE(parent > s);
        for (int r : rows) CHECK(((r >= factor.first[parent] && r < factor.first[parent + 1]) || above.count(r) == 1));
      }
    }
  }
}

TEST_CASE("ordering: vertex cuts are minimal, compared with all others") {
  Random random(3);
  for (int round = 0; round < 400; ++round) {
    const int band = 1 + random.below(10), size = band + 4;  // followed by two nodes Left and two Right
    std::vector<std::pair<int, int>> edges;
    for (int i = random.below(5 * band); i > 0; --i) edges.emplace_back(random.below(band), random.below(size));
    const Graph graph = graphFromEdges(size, edges);
    std::vector<Side> side(size, Side::Separator);
    for (int v = band; v < size; ++v) side[v] = v < band + 2 ? Side::Left : Side::Right;

    // Whether the band without a set of nodes separates Left and Right.
    const auto separatesWithout = [&](unsigned removed) {
      std::vector<char> reached(size, 0);
      std::vector<int> stack = {band, band + 1};
      while (!stack.empty()) {
        const int v = stack.back();
        stack.pop_back();
        if (reached[v] || (v < band && ((removed >> v) & 1))) continue;
        reached[v] = 1;
        for (int u : graph.neighbours(v)) stack.push_back(u);
      }
      return !reached[band + 2] && !reached[band + 3];
    };
    int smallest = band;
    for (unsigned set = 0; set < (1u << band); ++set)
      if (std::popcount(set) < smallest && separatesWithout(set)) smallest = std::popcount(set);
    shrinkSeparator(graph, side);
    CHECK(separates(graph, side));
    CHECK(sizes(side)[2] == smallest);
  }
}

TEST_CASE("ordering: separators separate, are balanced and near the shortest") {
  Random random(4);
  const PlainMesh sheet = irregularSheet(120, 30, random);
  const Graph graph = meshGraph(sheet);
  const std::vector<Side> side = findSeparator(graph, sheet.positions);
  REQUIRE(separates(graph, side));
  const auto [left, right, separator] = sizes(side);
  CHECK(separator <= 30);  // one column of the sheet
  CHECK(std::max(left, right) <= 0.73 * graph.size());
}

TEST_CASE("ordering: nested dissection has far less fill than the given order and less than minimum degree") {
  Random random(6);
  PlainMesh mesh = bumpySphere(64, random);
  shuffleVertices(mesh, random);
  const Graph graph = meshGraph(mesh);
  const std::vector<int> dissected = nestedDissectionOrder(graph, mesh.positions);
  REQUIRE(isPermutation(dissected, graph.size()));
  const double ratio = static_cast<double>(factorEntries(graph, dissected)) /
                       static_cast<double>(factorEntries(graph, minimumDegreeOrder(graph)));
  MESSAGE("entries of the factor, nested dissection over minimum degree, " << graph.size() << " vertices: " << ratio);
  CHECK(ratio < 0.9);
  CHECK(nestedDissectionOrder(graph, mesh.positions) == dissected);
}

TEST_CASE("ordering: clusters contain neighbours, and are adjacent like their nodes") {
  Random random(9);
  const PlainMesh sheet = irregularSheet(60, 40, random);
  for (const Graph& graph : {meshGraph(sheet), randomGraph(400, 300, random), graphFromEdges(3, {}), Graph{}}) {
    const GraphClusters clusters = clusterNodes(graph);
    REQUIRE(static_cast<int>(clusters.ofNode.size()) == graph.size());
    std::set<std::pair<int, int>> bordering, found;
    std::vector<int> lone(clusters.graph.size(), 0), size(clusters.graph.size(), 0);
    for (int v = 0; v < graph.size(); ++v) {
      const int cluster = clusters.ofNode[v];
      ++size[cluster];
      bool joined = false;
      for (const int u : graph.neighbours(v)) {
        joined = joined || clusters.ofNode[u] == cluster;
        if (clusters.ofNode[u] != cluster) bordering.emplace(cluster, clusters.ofNode[u]);
      }
      if (!joined) ++lone[cluster];
    }
    for (int c = 0; c < clusters.graph.size(); ++c) {
      CHECK(size[c] > 0);
      CHECK(lone[c] == (size[c] == 1 ? 1 : 0));
      for (const int other : clusters.graph.neighbours(c)) found.emplace(c, other);
    }
    CHECK(found == bordering);
    CHECK(found.size() == clusters.graph.neighbour.size());
  }
  const Graph graph = meshGraph(sheet);
  CHECK(5 * clusterNodes(graph).graph.size() < graph.size());
}

TEST_CASE("ordering: nested dissection works on large graphs that are not meshes") {
  Random random(8);
  const int size = 7000;  // large enough for division by clusters
  const std::vector<Vec3> same(size, Vec3(1, 2, 3)), scattered = randomPoints(size, random);
  std::vector<std::pair<int, int>> none, path, star;
  for (int i = 1; i < size; ++i) path.emplace_back(i - 1, i), star.emplace_back(0, i);
  for (const auto& edges : {none, path, star})
    for (const auto& points : {same, scattered})
      CHECK(isPermutation(nestedDissectionOrder(graphFromEdges(size, edges), points), size));
  CHECK(isPermutation(nestedDissectionOrder(randomGraph(size, 12000, random), scattered), size));
}

TEST_CASE("ordering: nested dissection works on graphs that are not meshes") {
  Random random(7);
  const int size = 500;
  const std::vector<Vec3> same(size, Vec3(1, 2, 3)), scattered = randomPoints(size, random);
  std::vector<std::pair<int, int>> none, path, star, complete;
  for (int i = 1; i < size; ++i) path.emplace_back(i - 1, i), star.emplace_back(0, i);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < i; ++j) complete.emplace_back(i, j);
  for (const auto& edges : {none, path, star, complete})
    for (const auto& points : {same, scattered}) {
      const Graph graph = graphFromEdges(size, edges);
      CHECK(isPermutation(nestedDissectionOrder(graph, points), size));
    }
  CHECK(isPermutation(nestedDissectionOrder(randomGraph(size, 2000, random), scattered), size));
  CHECK(nestedDissectionOrder(Graph{}, {}).empty());
  // Many leaves around one dense node. The leaf's neighbours exceed its bit sets.
  std::vector<std::pair<int, int>> hubs;
  for (int hub = 0; hub < 300; ++hub)
    for (int i = 300; i < size; ++i) hubs.emplace_back(hub, i);
  CHECK(isPermutation(nestedDissectionOrder(graphFromEdges(size, hubs), scattered), size));
}

}  // namespace shapespline::test::ordering_test
