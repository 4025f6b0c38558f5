#include "core/mesh/mesh.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/base/compressed_rows.h"
#include "core/base/union_find.h"
#include "core/mesh/triangle.h"

namespace shapespline {

namespace {

template <class Item>
void sortRows(CompressedRows<Item>& rows, const FractionReport& onProgress) {
  inBlocks(onProgress, static_cast<std::size_t>(rows.count()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const std::span<Item> row = rows.of(static_cast<int>(r));
      std::sort(row.begin(), row.end());
    }
  });
}

// One side 3 f + c of a face without its lower vertex, packed as: higher vertex, side, direction (high to low).
class Side {
 public:
  Side() = default;
  Side(int high, int index, bool reversed)
      : bits_(static_cast<std::uint64_t>(high) << 33 | static_cast<std::uint64_t>(index) << 1 |
              static_cast<std::uint64_t>(reversed)) {}
  int high() const { return static_cast<int>(bits_ >> 33); }
  int index() const { return static_cast<int>(bits_ >> 1 & 0xffffffff); }
  int face() const { return index() / 3; }
  bool reversed() const { return bits_ & 1; }
  bool operator<(Side other) const { return bits_ < other.bits_; }

 private:
  std::uint64_t bits_ = 0;
};

// Sides of faces in buckets by lower vertex, sorted by higher vertex. Sides of one edge are then consecutive.
template <class Use>
CompressedRows<Side> collectSides(int vertexCount, const std::vector<Triangle>& faces, Use use,
                                  const FractionReport& onProgress = {}) {
  const auto sidesOf = [&](std::size_t f, auto add) {
    if (!use(static_cast<int>(f))) return;
    for (int c = 0; c < 3; ++c) {
      const int a = faces[f][c], b = faces[f][(c + 1) % 3];
      if (a != b) add(std::min(a, b), Side(std::max(a, b), 3 * static_cast<int>(f) + c, a > b));
    }
  };
  CompressedRows<Side> sides = compressedRows<Side>(vertexCount, faces.size(), sidesOf, partOf(onProgress, 0, 0.6));
  sortRows(sides, partOf(onProgress, 0.6, 1));
  return sides;
}

// Calls visit for each edge and its sides.
template <class Visit>
void eachEdge(CompressedRows<Side>& sides, const FractionReport& onProgress, Visit visit) {
  inBlocks(onProgress, static_cast<std::size_t>(sides.count()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::span<const Side> row = sides.of(static_cast<int>(v));
      for (std::size_t a = 0, b; a < row.size(); a = b) {
        for (b = a + 1; b < row.size() && row[b].high() == row[a].high(); ++b) {
        }
        visit(row.subspan(a, b - a));
      }
    }
  });
}

FaceGraph graphOf(int faceCount, const std::vector<std::pair<int, int>>& links, const FractionReport& onProgress) {
  const auto endsOf = [&](std::size_t i, auto add) {
    const auto [a, b] = links[i];
    add(a, b);
    add(b, a);
  };
  return compressedRows<int>(faceCount, links.size(), endsOf, onProgress);
}

int countDuplicates(int vertexCount, const std::vector<Triangle>& faces, const FractionReport& onProgress) {
  using Rest = std::uint64_t;  // a face's vertices without the lowest: the middle one, then the highest
  const auto restOf = [&](std::size_t f, auto add) {
    const auto [a, b, c] = faces[f];
    const int low = std::min({a, b, c}), high = std::max({a, b, c}), middle = a ^ b ^ c ^ low ^ high;
    add(low, static_cast<Rest>(middle) << 32 | static_cast<Rest>(high));
  };
  CompressedRows<Rest> rests = compressedRows<Rest>(vertexCount, faces.size(), restOf, partOf(onProgress, 0, 0.6));
  sortRows(rests, partOf(onProgress, 0.6, 1));
  int count = 0;
  for (int v = 0; v < vertexCount; ++v) {
    const std::span<const Rest> row = rests.of(v);
    for (std::size_t i = 1; i < row.size(); ++i) count += row[i] == row[i - 1];
  }
  return count;
}

}  // namespace

VertexFaces facesOfVertices(int vertexCount, const std::vector<Triangle>& faces) {
  const auto cornersOf = [&](std::size_t f, auto add) {
    for (int v : faces[f]) add(v, static_cast<int>(f));
  };
  return compressedRows<int>(vertexCount, faces.size(), cornersOf, {});
}

MeshCounts countMesh(int vertexCount, const std::vector<Triangle>& faces, const FractionReport& onProgress) {
  MeshCounts counts;
  CompressedRows<Side> sides = collectSides(vertexCount, faces, [](int) { return true; }, partOf(onProgress, 0, 0.6));
  eachEdge(sides, partOf(onProgress, 0.6, 0.7), [&](std::span<const Side> edge) {
    ++counts.edges;
    if (edge.size() == 1) ++counts.boundaryEdges;
    if (edge.size() > 2) ++counts.nonManifoldEdges;
    if (edge.size() == 2 && edge[0].reversed() == edge[1].reversed()) ++counts.inconsistentEdges;
  });
  sides = {};
  counts.duplicateFaces = countDuplicates(vertexCount, faces, partOf(onProgress, 0.7, 1));
  return counts;
}

int countUnreferenced(int vertexCount, const std::vector<Triangle>& faces) {
  std::vector<char> seen(vertexCount, 0);
  for (const Triangle& f : faces)
    for (int v : f) seen[v] = 1;
  return static_cast<int>(std::count(seen.begin(), seen.end(), 0));
}

int countComponents(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress) {
  UnionFind joined(vertexCount);
  std::vector<char> seen(vertexCount, 0);
  int components = 0;
  inBlocks(onProgress, faces.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (!use[f]) continue;
      for (int v : faces[f]) {
        components += !seen[v];
        seen[v] = 1;
      }
      for (int c = 1; c < 3; ++c) components -= joined.join(faces[f][0], faces[f][c]);
    }
  });
  return components;
}

FaceGraph dualGraph(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress) {
  const int faceCount = static_cast<int>(faces.size());
  std::vector<std::pair<int, int>> links;
  UnionFind joined(faceCount);
  CompressedRows<Side> sides =
      collectSides(vertexCount, faces, [&](int f) { return use[f] != 0; }, partOf(onProgress, 0, 0.5));
  links.reserve(sides.item.size() / 2);
  eachEdge(sides, partOf(onProgress, 0.5, 0.65), [&](std::span<const Side> edge) {
    // Links consecutive faces at a non-manifold edge. This connects them with linearly many links.
    for (std::size_t i = 1; i < edge.size(); ++i) {
      const int a = edge[i - 1].face(), b = edge[i].face();
      if (a == b) continue;
      links.emplace_back(a, b);
      joined.join(a, b);
    }
  });
  sides = {};
  std::vector<int> firstAt(vertexCount, -1);
  inBlocks(partOf(onProgress, 0.65, 0.8), faces.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (!use[f]) continue;
      for (int v : faces[f]) {
        if (firstAt[v] < 0) firstAt[v] = static_cast<int>(f);
        else if (joined.join(firstAt[v], static_cast<int>(f))) links.emplace_back(firstAt[v], static_cast<int>(f));
      }
    }
  });
  return graphOf(faceCount, links, partOf(onProgress, 0.8, 1));
}

std::vector<int> nextAlongEdge(int vertexCount, const std::vector<Triangle>& faces, const FractionReport& onProgress) {
  CompressedRows<Side> sides = collectSides(vertexCount, faces, [](int) { return true; }, partOf(onProgress, 0, 0.8));
  std::vector<int> next(3 * faces.size());
  std::iota(next.begin(), next.end(), 0);
  eachEdge(sides, partOf(onProgress, 0.8, 1), [&](std::span<const Side> edge) {
    for (std::size_t i = 0; i < edge.size(); ++i) next[edge[i].index()] = edge[(i + 1) % edge.size()].index();
  });
  return next;
}

Components connectedComponents(const FaceGraph& graph, const std::vector<char>& use, const FractionReport& onProgress) {
  Components components;
  UnionFind joined(static_cast<int>(use.size()));
  inBlocks(partOf(onProgress, 0, 0.8), use.size(), [&](std::size_t begin, std::size_t end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f)
      for (int g : graph.of(f))
        if (g > f) joined.join(f, g);
  });
  components.ofFace.assign(use.size(), -1);
  inBlocks(partOf(onProgress, 0.8, 1), use.size(), [&](std::size_t begin, std::size_t end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) {
      if (!use[f]) continue;
      const int first = joined.find(f);  // lowest face of the component
      components.ofFace[f] = first == f ? components.count++ : components.ofFace[first];
    }
  });
  return components;
}

std::vector<char> facesWithArea(const std::vector<Triangle>& faces, std::span<const Positions* const> poses,
                                const FractionReport& onProgress) {
  std::vector<char> hasArea(faces.size());
  inBlocks(onProgress, faces.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = faces[f];
      hasArea[f] = std::none_of(poses.begin(), poses.end(),
                                [a, b, c](const Positions* p) { return isDegenerate((*p)[a], (*p)[b], (*p)[c]); });
    }
  });
  return hasArea;
}

double boundingDiagonal(std::span<const Positions* const> poses) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Positions* pose : poses)
    for (const Vec3& p : *pose) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return (high.array() >= low.array()).all() ? (high - low).norm() : 0;
}

}  // namespace shapespline
