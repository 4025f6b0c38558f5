#include "core/mesh/same_surface.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/base/union_find.h"

namespace shapespline {

namespace {

using Arc = std::array<int, 2>;  // start and end vertex

Triangle fromLowestVertex(const Triangle& f) {
  const int start = static_cast<int>(std::min_element(f.begin(), f.end()) - f.begin());
  return {f[start], f[(start + 1) % 3], f[(start + 2) % 3]};
}

std::vector<Triangle> inOrder(const std::vector<Triangle>& faces) {
  std::vector<Triangle> sorted(faces.size());
  std::transform(faces.begin(), faces.end(), sorted.begin(), fromLowestVertex);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Arc arcOf(const Triangle& f, int c) { return {f[c], f[(c + 1) % 3]}; }

Arc undirected(const Arc& s) { return {std::min(s[0], s[1]), std::max(s[0], s[1])}; }

std::vector<Arc> edgesOf(const std::vector<Triangle>& faces) {
  std::vector<Arc> edges;
  for (const Triangle& f : faces)
    for (int c = 0; c < 3; ++c) edges.push_back(undirected(arcOf(f, c)));
  std::sort(edges.begin(), edges.end());
  return edges;
}

// The polygons behind the faces, each as its sorted sides. Faces are joined across edges that `other`, the edges of
// another cut of the same polygons, lacks. Empty if a joined region has inner vertices.
std::vector<std::vector<Arc>> polygonsOf(const std::vector<Triangle>& faces, const std::vector<Arc>& other) {
  std::vector<std::pair<Arc, int>> sides;  // sides with their faces
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int c = 0; c < 3; ++c) sides.push_back({arcOf(faces[f], c), f});
  std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
    const Arc ea = undirected(a.first), eb = undirected(b.first);
    return ea != eb ? ea < eb : a < b;
  });

  UnionFind joined(static_cast<int>(faces.size()));
  std::vector<std::pair<int, Arc>> outer;  // sides with a face of their polygon
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    const Arc edge = undirected(sides[i].first);
    for (next = i; next < sides.size() && undirected(sides[next].first) == edge; ++next) {
    }
    if (!std::binary_search(other.begin(), other.end(), edge)) {
      if (next - i != 2 || sides[i].first == sides[i + 1].first || !joined.join(sides[i].second, sides[i + 1].second))
        return {};
      continue;
    }
    for (std::size_t s = i; s < next; ++s) outer.push_back({sides[s].second, sides[s].first});
  }

  std::vector<int> triangles(faces.size(), 0);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) ++triangles[joined.find(f)];
  std::vector<std::vector<Arc>> polygonAt(faces.size()), polygons;
  for (const auto& [face, s] : outer) polygonAt[joined.find(face)].push_back(s);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (triangles[f] == 0) continue;
    std::vector<Arc>& polygon = polygonAt[f];
    if (static_cast<int>(polygon.size()) != triangles[f] + 2) return {};
    std::sort(polygon.begin(), polygon.end());
    polygons.push_back(std::move(polygon));
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

}  // namespace

bool sameTriangle(const Triangle& a, const Triangle& b) {
  return b == a || b == Triangle{a[1], a[2], a[0]} || b == Triangle{a[2], a[0], a[1]};
}

bool sameSurface(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  if (a.size() != b.size()) return false;
  if (std::equal(a.begin(), a.end(), b.begin(), sameTriangle)) return true;
  const std::vector<Triangle> allA = inOrder(a), allB = inOrder(b);
  std::vector<Triangle> onlyA, onlyB;
  std::set_difference(allA.begin(), allA.end(), allB.begin(), allB.end(), std::back_inserter(onlyA));
  std::set_difference(allB.begin(), allB.end(), allA.begin(), allA.end(), std::back_inserter(onlyB));
  if (onlyA.empty()) return true;
  const auto polygonsA = polygonsOf(onlyA, edgesOf(onlyB)), polygonsB = polygonsOf(onlyB, edgesOf(onlyA));
  return !polygonsA.empty() && polygonsA == polygonsB;
}

}  // namespace shapespline
