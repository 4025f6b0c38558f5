#include "shapes/shape_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

namespace shapespline {
namespace {

using Edge = std::pair<int, int>;

std::map<Edge, int> faceOfEdge(const std::vector<Triangle>& faces, bool& unique) {
  std::map<Edge, int> result;
  unique = true;
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    for (int c = 0; c < 3; ++c) unique &= result.try_emplace({faces[f][c], faces[f][(c + 1) % 3]}, f).second;
  }
  return result;
}

Vec3 normalOf(const Triangle& face, const Positions& p) {
  return (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]).normalized();
}

double degrees(double radians) { return radians * 180 / M_PI; }

// Whether segment a-b passes through triangle (p, q, r).
bool pierces(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 normal = (q - p).cross(r - p);
  const double da = normal.dot(a - p), db = normal.dot(b - p);
  if ((da > 0) == (db > 0)) return false;
  const Vec3 hit = a + da / (da - db) * (b - a);
  const auto leftOf = [&](const Vec3& from, const Vec3& to) { return normal.dot((to - from).cross(hit - from)) > 0; };
  return leftOf(p, q) && leftOf(q, r) && leftOf(r, p);
}

bool cut(const Triangle& f, const Triangle& g, const Positions& p) {
  for (int c = 0; c < 3; ++c) {
    if (pierces(p[f[c]], p[f[(c + 1) % 3]], p[g[0]], p[g[1]], p[g[2]])) return true;
    if (pierces(p[g[c]], p[g[(c + 1) % 3]], p[f[0]], p[f[1]], p[f[2]])) return true;
  }
  return false;
}

bool touch(const Triangle& f, const Triangle& g) {
  return std::any_of(f.begin(), f.end(), [&](int v) { return std::find(g.begin(), g.end(), v) != g.end(); });
}

// Faces by the grid cells that their bounding boxes overlap.
std::unordered_map<std::int64_t, std::vector<int>> faceGrid(const std::vector<Triangle>& faces, const Positions& p) {
  double cell = 0;
  for (const Triangle& f : faces) cell = std::max(cell, (p[f[1]] - p[f[0]]).norm());
  std::unordered_map<std::int64_t, std::vector<int>> grid;
  for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
    const auto& [a, b, c] = faces[i];
    const Vec3 low = (p[a].cwiseMin(p[b]).cwiseMin(p[c]) / cell).array().floor();
    const Vec3 high = (p[a].cwiseMax(p[b]).cwiseMax(p[c]) / cell).array().floor();
    for (double x = low.x(); x <= high.x(); ++x) {
      for (double y = low.y(); y <= high.y(); ++y) {
        for (double z = low.z(); z <= high.z(); ++z) {
          grid[(std::int64_t(x) * 2097152 + std::int64_t(y)) * 2097152 + std::int64_t(z)].push_back(i);
        }
      }
    }
  }
  return grid;
}

}  // namespace

bool isClosedManifold(const std::vector<Triangle>& faces, int vertices) {
  bool closed = true;
  const auto faceOf = faceOfEdge(faces, closed);
  std::vector<int> start(vertices, -1), valence(vertices, 0);
  for (const auto& [edge, face] : faceOf) closed &= faceOf.count({edge.second, edge.first}) == 1;
  if (!closed) return false;
  for (const Triangle& face : faces) {
    for (int c = 0; c < 3; ++c) {
      start[face[c]] = face[(c + 1) % 3];
      ++valence[face[c]];
    }
  }
  for (int v = 0; v < vertices; ++v) {
    if (start[v] < 0) return false;
    int steps = 0, next = start[v];
    do {
      const Triangle& face = faces[faceOf.at({v, next})];
      next = face[(std::find(face.begin(), face.end(), v) - face.begin() + 2) % 3];
      ++steps;
    } while (next != start[v]);
    if (steps != valence[v]) return false;
  }
  return true;
}

double smallestAngle(const std::vector<Triangle>& faces, const Positions& p) {
  double smallest = M_PI;
  for (const Triangle& f : faces) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 u = p[f[(c + 1) % 3]] - p[f[c]], v = p[f[(c + 2) % 3]] - p[f[c]];
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return degrees(smallest);
}

double sharpestEdge(const std::vector<Triangle>& faces, const Positions& p) {
  bool unique = true;
  const auto faceOf = faceOfEdge(faces, unique);
  double cosine = 1;
  for (const auto& [edge, face] : faceOf) {
    const auto other = faceOf.find({edge.second, edge.first});
    if (other == faceOf.end()) continue;
    cosine = std::min(cosine, normalOf(faces[face], p).dot(normalOf(faces[other->second], p)));
  }
  return degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

int selfIntersections(const std::vector<Triangle>& faces, const Positions& positions) {
  std::vector<Edge> pairs;
  for (const auto& [cell, members] : faceGrid(faces, positions)) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const int f = std::min(members[i], members[j]), g = std::max(members[i], members[j]);
        if (f != g && !touch(faces[f], faces[g]) && cut(faces[f], faces[g], positions)) pairs.push_back({f, g});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return static_cast<int>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace shapespline
