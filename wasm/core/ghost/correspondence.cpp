#include "core/ghost/correspondence.h"

#include <algorithm>
#include <limits>

namespace shapespline {

namespace {

// Distances that differ by less than this share of the face's size count as equal.
constexpr double tie = 1e-4;

constexpr int facesPerReport = 32768;

double squaredDistanceToEdge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double length = edge.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0;
  return (p - a - t * edge).squaredNorm();
}

}  // namespace

double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(p - from).dot(normal) >= 0; };
  const double squared = normal.squaredNorm();
  if (squared > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    const double height = (p - a).dot(normal);
    return height * height / squared;
  }
  return std::min({squaredDistanceToEdge(p, a, b), squaredDistanceToEdge(p, b, c), squaredDistanceToEdge(p, c, a)});
}

std::vector<int> correspondingFaces(const WeldedShape& shape, const ShapeTopology& topology, const GhostMesh& ghost,
                                    const FractionReport& onProgress) {
  const Positions& p = shape.poses[shape.reference];
  const Positions& g = ghost.poses[shape.reference];
  const VertexFaces ghostFacesAt = facesOfVertices(static_cast<int>(g.size()), ghost.faces);
  std::vector<int> result(shape.faceCount(), -1);
  std::vector<int> candidates;
  const auto nearest = [&](int f) {
    candidates.clear();
    for (int v : shape.faces[f])
      if (ghost.ghostOf[v] >= 0)
        for (int face : ghostFacesAt.of(ghost.ghostOf[v])) candidates.push_back(face);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    const Vec3 centroid = centroidOf(p, shape.faces[f]);
    const double margin = tie * tie * (p[shape.faces[f][0]] - centroid).squaredNorm();
    double best = std::numeric_limits<double>::infinity();
    int face = -1;
    for (int c : candidates) {
      const Triangle& t = ghost.faces[c];
      const double distance = squaredDistance(centroid, g[t[0]], g[t[1]], g[t[2]]);
      if (distance < best - margin) {
        best = distance;
        face = c;
      }
    }
    return face;
  };
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (topology.turns[f]) result[f] = nearest(f);
    if (f % facesPerReport == 0) onProgress(static_cast<double>(f) / shape.faceCount());
  }

  std::vector<int> follows(topology.components.count, 0);  // ghost face for components without a ghost
  for (int component : topology.tree.order)
    if (const ComponentLink& link = topology.tree.link[component]; link.parent >= 0)
      follows[component] = result[link.anchorFace] >= 0 ? result[link.anchorFace] : follows[link.parent];
  for (int f = 0; f < shape.faceCount(); ++f)
    if (topology.turns[f] && result[f] < 0) result[f] = follows[topology.components.ofFace[f]];
  for (int f = 0; f < shape.faceCount(); ++f)
    if (topology.anchor[f] >= 0) result[f] = result[topology.anchor[f]];
  return result;
}

}  // namespace shapespline
