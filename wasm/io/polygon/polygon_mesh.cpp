#include "io/polygon/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace shapespline {

namespace {

// Limit for the search of ears, which takes quadratic time. Larger polygons are cut into fans.
constexpr int maxEarCorners = 512;
// From this size on, convex polygons are cut into fans.
constexpr int manyCorners = 33;

struct Polygon {
  const PolygonMesh& mesh;
  int start, size;
  Vec3 normal = Vec3::Zero();

  Polygon(const PolygonMesh& mesh, int index)
      : mesh(mesh), start(mesh.firstCorner(index)), size(mesh.ends[index] - start) {
    // Newell's method: twice the area vector.
    for (int c = 0; c < size; ++c) normal += point(c).cross(point((c + 1) % size));
  }

  const Vec3& point(int corner) const { return mesh.positions[mesh.corners[start + corner]]; }

  // Twice the triangle's area, negative if its orientation opposes the polygon's.
  double area(int a, int b, int c) const { return (point(b) - point(a)).cross(point(c) - point(a)).dot(normal); }

  double diagonal(int a, int b) const { return (point(a) - point(b)).squaredNorm(); }
};

void cutQuad(const Polygon& p, PolygonCuts& cuts) {
  // Chooses a diagonal: first, neither triangle may be reversed; then the shorter one is better.
  const double first = std::min(p.area(0, 1, 2), p.area(0, 2, 3)), second = std::min(p.area(1, 2, 3), p.area(1, 3, 0));
  const bool firstInside = first > 0, secondInside = second > 0;
  const bool takeSecond = firstInside == secondInside ? p.diagonal(1, 3) < p.diagonal(0, 2) : secondInside;
  if (takeSecond) cuts.insert(cuts.end(), {{1, 2, 3}, {1, 3, 0}});
  else cuts.insert(cuts.end(), {{0, 1, 2}, {0, 2, 3}});
}

// The corners that are not cut yet, in cyclic order.
struct Ring {
  const Polygon& polygon;
  std::vector<int> corners;

  int size() const { return static_cast<int>(corners.size()); }
  int at(int i) const { return corners[(i + size()) % size()]; }
  const Vec3& point(int i) const { return polygon.point(at(i)); }
  double area(int i) const { return polygon.area(at(i - 1), at(i), at(i + 1)); }

  // Whether corner q prevents cutting the ear at corner i. A hole is joined to the outline by a bridge, so several
  // corners may be at one point. At the ear's tip, such a corner's sides may enter the ear.
  bool blocks(int q, int i) const {
    const int a = at(i - 1), b = at(i), c = at(i + 1);
    if (!(polygon.area(c, a, at(q)) >= 0)) return false;
    const Vec3& p = point(q);
    if (p == point(i - 1) || p == point(i + 1)) return false;
    const auto enters = [&](int corner) { return polygon.area(a, b, corner) > 0 && polygon.area(b, c, corner) > 0; };
    if (p == point(i)) return enters(at(q - 1)) || enters(at(q + 1));
    return polygon.area(a, b, at(q)) >= 0 && polygon.area(b, c, at(q)) >= 0;
  }

  bool isEar(int i) const {
    if (!(area(i) > 0)) return false;
    for (int q = i + 2; q < i - 1 + size(); ++q)
      if (blocks(q, i)) return false;
    return true;
  }
};

// Repeatedly cuts the ear with the shortest diagonal.
void cutEars(const Polygon& p, PolygonCuts& cuts) {
  Ring ring{p, std::vector<int>(p.size)};
  std::iota(ring.corners.begin(), ring.corners.end(), 0);
  std::vector<char> isEar(p.size);
  for (int i = 0; i < p.size; ++i) isEar[i] = ring.isEar(i);
  while (ring.size() > 3) {
    int best = -1;
    double shortest = 0;
    for (int i = 0; i < ring.size(); ++i) {
      if (!isEar[i]) continue;
      const double length = p.diagonal(ring.at(i - 1), ring.at(i + 1));
      if (best < 0 || length < shortest) {
        best = i;
        shortest = length;
      }
    }
    // For self-intersecting or flat polygons, any cut works if all keys share it. The flattest one covers least.
    if (best < 0) {
      best = 1;
      for (int i = 0; i < ring.size(); ++i)
        if (std::abs(ring.area(i)) < std::abs(ring.area(best))) best = i;
    }
    cuts.push_back({ring.at(best - 1), ring.at(best), ring.at(best + 1)});
    ring.corners.erase(ring.corners.begin() + best);
    isEar.erase(isEar.begin() + best);
    for (int i : {best - 1, best}) isEar[(i + ring.size()) % ring.size()] = ring.isEar(i);
  }
  cuts.push_back({ring.at(0), ring.at(1), ring.at(2)});
}

bool isConvex(const Polygon& p) {
  for (int c = 0; c < p.size; ++c)
    if (!(p.area(c, (c + 1) % p.size, (c + 2) % p.size) > 0)) return false;
  return true;
}

void cutFan(int size, PolygonCuts& cuts) {
  for (int c = 1; c + 1 < size; ++c) cuts.push_back({0, c, c + 1});
}

void addTriangle(const std::vector<int>& corners, int start, const Triangle& cut, std::vector<Triangle>& out) {
  out.push_back({corners[start + cut[0]], corners[start + cut[1]], corners[start + cut[2]]});
}

std::vector<Triangle> fans(const PolygonMesh& mesh, const std::vector<int>& corners) {
  std::vector<Triangle> out;
  PolygonCuts cuts;
  for (int p = 0; p < mesh.polygonCount(); ++p) {
    const int start = mesh.firstCorner(p);
    cuts.clear();
    cutFan(mesh.ends[p] - start, cuts);
    for (const Triangle& cut : cuts) addTriangle(corners, start, cut, out);
  }
  return out;
}

// Checks the number of triangles of each polygon, which also locates the polygon's cuts.
bool fits(const PolygonMesh& mesh, const PolygonCuts& cuts) {
  if (mesh.corners.size() - 2 * mesh.ends.size() != cuts.size()) return false;
  std::size_t next = 0;
  for (int p = 0; p < mesh.polygonCount(); ++p) {
    const int size = mesh.ends[p] - mesh.firstCorner(p);
    int last = 0;
    for (int t = 0; t < size - 2; ++t, ++next) last = std::max({last, cuts[next][0], cuts[next][1], cuts[next][2]});
    if (last != size - 1) return false;
  }
  return true;
}

// `corners`: a vertex for each corner of each polygon.
std::vector<Triangle> cutTriangles(const PolygonMesh& mesh, const std::vector<int>& corners, const PolygonCuts& cuts) {
  if (!fits(mesh, cuts)) return fans(mesh, corners);
  std::vector<Triangle> out;
  out.reserve(cuts.size());
  for (int p = 0; p < mesh.polygonCount(); ++p) {
    const int start = mesh.firstCorner(p);
    for (int left = mesh.ends[p] - start - 2; left > 0; --left) addTriangle(corners, start, cuts[out.size()], out);
  }
  return out;
}

int trianglesBefore(const PolygonMesh& mesh, int polygon) { return mesh.firstCorner(polygon) - 2 * polygon; }

}  // namespace

void placeUnused(PolygonMesh& mesh) {
  std::vector<char> isUsed(mesh.positions.size(), 0);
  for (int corner : mesh.corners) isUsed[corner] = 1;
  for (std::size_t v = 0; v < isUsed.size(); ++v)
    if (!isUsed[v] && !mesh.positions[v].allFinite()) mesh.positions[v] = mesh.positions[mesh.corners[0]];
}

PolygonCuts cutPolygons(const PolygonMesh& mesh) {
  PolygonCuts cuts;
  cuts.reserve(mesh.corners.size() - 2 * mesh.ends.size());
  for (int i = 0; i < mesh.polygonCount(); ++i) {
    const int size = mesh.ends[i] - mesh.firstCorner(i);
    if (size == 3) cuts.push_back({0, 1, 2});
    else if (size == 4) cutQuad(Polygon(mesh, i), cuts);
    else if (size <= maxEarCorners && !(size >= manyCorners && isConvex(Polygon(mesh, i))))
      cutEars(Polygon(mesh, i), cuts);
    else cutFan(size, cuts);
  }
  return cuts;
}

PolygonCuts cutPolygonsLike(const PolygonMesh& mesh, const std::vector<Triangle>& triangles) {
  PolygonCuts cuts;
  if (mesh.corners.size() - 2 * mesh.ends.size() != triangles.size()) return cutPolygons(mesh);
  cuts.reserve(triangles.size());
  for (int p = 0; p < mesh.polygonCount(); ++p) {
    const auto first = mesh.corners.begin() + mesh.firstCorner(p), last = mesh.corners.begin() + mesh.ends[p];
    const int size = static_cast<int>(last - first);
    if (size > maxEarCorners) {
      cutFan(size, cuts);
      continue;
    }
    for (int t = 0; t < size - 2; ++t) {
      const Triangle& triangle = triangles[cuts.size()];
      Triangle cut;
      // Searches from the end, because `fits` looks for the last corner, and corners may share a vertex.
      for (int c = 0; c < 3; ++c)
        cut[c] = static_cast<int>(
                     std::find(std::reverse_iterator(last), std::reverse_iterator(first), triangle[c]).base() - first) -
                 1;
      if (std::min({cut[0], cut[1], cut[2]}) < 0) return cutPolygons(mesh);
      cuts.push_back(cut);
    }
  }
  return cuts;
}

std::vector<Triangle> trianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts) {
  return cutTriangles(mesh, mesh.corners, cuts);
}

std::vector<Triangle> drawnTrianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts) {
  return mesh.drawn.empty() ? std::vector<Triangle>() : cutTriangles(mesh, mesh.drawn, cuts);
}

std::vector<int> trianglesPerPolygon(const PolygonMesh& mesh) {
  if (mesh.corners.size() == 3 * mesh.ends.size()) return {};
  std::vector<int> out(mesh.ends.size());
  for (int p = 0; p < mesh.polygonCount(); ++p) out[p] = mesh.ends[p] - mesh.firstCorner(p) - 2;
  return out;
}

std::vector<MaterialGroup> triangleGroups(const PolygonMesh& mesh) {
  std::vector<MaterialGroup> out;
  for (const MaterialGroup& g : mesh.scene.groups) {
    const int start = trianglesBefore(mesh, g.start);
    if (const int count = trianglesBefore(mesh, g.start + g.count) - start; count > 0)
      out.push_back({start, count, g.material, g.name});
  }
  return out;
}

std::vector<ObjectFaces> triangleObjects(const PolygonMesh& mesh) {
  std::vector<ObjectFaces> out = mesh.scene.objects;
  for (ObjectFaces& object : out) {
    const int start = trianglesBefore(mesh, object.start), end = trianglesBefore(mesh, object.start + object.count);
    object.start = start;
    object.count = end - start;
  }
  return out;
}

}  // namespace shapespline
