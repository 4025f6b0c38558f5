#include "core/mesh.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shapespline {

namespace {

// One side of a face: from its lower to its higher vertex, and whether the face runs the other way.
struct Side {
  int high;
  int face;
  bool reversed;
};

// Sides of faces, bucketed by their lower vertex and sorted by the higher, so that sides of one edge are consecutive.
struct Sides {
  std::vector<int> start;
  std::vector<Side> side;

  // Calls visit(first, last) for each edge with the range of its sides.
  template <class Visit>
  void eachEdge(Visit visit) const {
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
      for (int a = start[v], b; a < start[v + 1]; a = b) {
        for (b = a + 1; b < start[v + 1] && side[b].high == side[a].high; ++b) {}
        visit(side.data() + a, side.data() + b);
      }
  }
};

template <class Use>
Sides collectSides(int vertexCount, const std::vector<Triangle>& faces, Use use, const FractionReport& onProgress = {}) {
  Sides sides;
  sides.start.assign(vertexCount + 1, 0);
  const auto eachSide = [&](auto visit) {
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
      if (!use(f)) continue;
      for (int c = 0; c < 3; ++c) {
        const int a = faces[f][c], b = faces[f][(c + 1) % 3];
        if (a != b) visit(std::min(a, b), Side{std::max(a, b), f, a > b});
      }
    }
  };
  eachSide([&](int low, const Side&) { ++sides.start[low + 1]; });
  std::partial_sum(sides.start.begin(), sides.start.end(), sides.start.begin());
  sides.side.resize(sides.start.back());
  std::vector<int> next(sides.start.begin(), sides.start.end() - 1);
  eachSide([&](int low, const Side& side) { sides.side[next[low]++] = side; });
  const FractionReport onVertices = partOf(onProgress, 0.5, 1);
  for (int v = 0; v < vertexCount; ++v) {
    reportItem(onVertices, static_cast<std::size_t>(v), static_cast<std::size_t>(vertexCount));
    std::sort(sides.side.begin() + sides.start[v], sides.side.begin() + sides.start[v + 1],
              [](const Side& x, const Side& y) { return x.high != y.high ? x.high < y.high : x.face < y.face; });
  }
  return sides;
}

class UnionFind {
 public:
  explicit UnionFind(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  // Returns false where both were joined already.
  bool join(int a, int b) {
    a = find(a), b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<int> parent_;
};

FaceGraph graphOf(int faceCount, const std::vector<std::pair<int, int>>& links) {
  FaceGraph graph;
  graph.start.assign(faceCount + 1, 0);
  for (auto [a, b] : links) ++graph.start[a + 1], ++graph.start[b + 1];
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbour.resize(graph.start.back());
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  for (auto [a, b] : links) graph.neighbour[next[a]++] = b, graph.neighbour[next[b]++] = a;
  return graph;
}

int countDuplicates(const std::vector<Triangle>& faces) {
  std::vector<Triangle> sorted = faces;
  for (Triangle& f : sorted) std::sort(f.begin(), f.end());
  std::sort(sorted.begin(), sorted.end());
  const auto last = std::unique(sorted.begin(), sorted.end());
  return static_cast<int>(sorted.end() - last);
}

}  // namespace

VertexFaces facesOfVertices(int vertexCount, const std::vector<Triangle>& faces) {
  VertexFaces result;
  result.start.assign(vertexCount + 1, 0);
  for (const Triangle& f : faces)
    for (int v : f) ++result.start[v + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.face.resize(result.start.back());
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int v : faces[f]) result.face[next[v]++] = f;
  return result;
}

MeshCounts countMesh(int vertexCount, const std::vector<Triangle>& faces) {
  MeshCounts counts;
  const Sides sides = collectSides(vertexCount, faces, [](int) { return true; });
  sides.eachEdge([&](const Side* first, const Side* last) {
    ++counts.edges;
    if (last - first == 1) ++counts.boundaryEdges;
    if (last - first > 2) ++counts.nonManifoldEdges;
    if (last - first == 2 && first[0].reversed == first[1].reversed) ++counts.inconsistentEdges;
  });
  counts.duplicateFaces = countDuplicates(faces);
  std::vector<char> seen(vertexCount, 0);
  for (const Triangle& f : faces)
    for (int v : f) seen[v] = 1;
  counts.unreferencedVertices = static_cast<int>(std::count(seen.begin(), seen.end(), 0));
  return counts;
}

FaceGraph dualGraph(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress) {
  const int faceCount = static_cast<int>(faces.size());
  std::vector<std::pair<int, int>> links;
  UnionFind joined(faceCount);
  const Sides sides = collectSides(vertexCount, faces, [&](int f) { return use[f] != 0; }, partOf(onProgress, 0, 0.5));
  sides.eachEdge([&](const Side* first, const Side* last) {
    // Consecutive faces at a non-manifold edge: enough to connect them, and linear in their number.
    for (const Side* s = first; s + 1 < last; ++s) {
      if (s[0].face == s[1].face) continue;
      links.emplace_back(s[0].face, s[1].face);
      joined.join(s[0].face, s[1].face);
    }
  });
  reportFraction(onProgress, 0.7);
  std::vector<int> firstAt(vertexCount, -1);
  for (int f = 0; f < faceCount; ++f) {
    if (!use[f]) continue;
    for (int v : faces[f]) {
      if (firstAt[v] < 0) firstAt[v] = f;
      else if (joined.join(firstAt[v], f)) links.emplace_back(firstAt[v], f);
    }
  }
  reportFraction(onProgress, 0.9);
  return graphOf(faceCount, links);
}

Pieces connectedPieces(const FaceGraph& graph, const std::vector<char>& use) {
  Pieces pieces;
  const int faceCount = static_cast<int>(use.size());
  pieces.ofFace.assign(faceCount, -1);
  std::vector<int> stack;
  for (int seed = 0; seed < faceCount; ++seed) {
    if (!use[seed] || pieces.ofFace[seed] >= 0) continue;
    pieces.ofFace[seed] = pieces.count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int g : graph.of(f))
        if (pieces.ofFace[g] < 0) pieces.ofFace[g] = pieces.count, stack.push_back(g);
    }
    ++pieces.count;
  }
  return pieces;
}

double boundingDiagonal(std::span<const Positions* const> poses) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Positions* pose : poses)
    for (const Vec3& p : *pose) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high.array() >= low.array()).all() ? (high - low).norm() : 0;
}

}  // namespace shapespline
