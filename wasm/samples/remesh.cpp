#include "samples/remesh.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "samples/edit_mesh.h"
#include "samples/polygonise.h"

namespace shapespline {
namespace {

// Botsch and Kobbelt's bounds: an edge beyond them is nearer to the wanted length after its split or collapse.
constexpr double longest = 4.0 / 3, shortest = 4.0 / 5;

class Remesher {
 public:
  Remesher(Surface surface, const Field& field, const EdgeLength& edge)
      : mesh_(std::move(surface)), field_(field), edge_(edge) {}

  void round() {
    measure();
    mesh_.splitEdges([&](int a, int b) { return length(a, b) > longest * wanted(a, b); });
    measure();
    collapseShort();
    mesh_.compact();
    measure();
    flip();
    relax();
  }

  Surface take() { return mesh_.take(); }

 private:
  void measure() {
    wanted_.resize(mesh_.vertexCount());
    for (int v = 0; v < mesh_.vertexCount(); ++v) wanted_[v] = edge_(mesh_.position(v));
  }

  double wanted(int a, int b) const { return 0.5 * (wanted_[a] + wanted_[b]); }
  double length(int a, int b) const { return (mesh_.position(a) - mesh_.position(b)).norm(); }

  void collapseShort() {
    for (int a = 0; a < mesh_.vertexCount(); ++a) {
      for (int b : mesh_.ring(a)) {
        if (length(a, b) >= shortest * wanted(a, b)) continue;
        const Vec3 middle = 0.5 * (mesh_.position(a) + mesh_.position(b));
        const double limit = longest * wanted(a, b);
        if (mesh_.collapse(a, b, middle, [&](const Vec3& p, const Vec3& q) { return (p - q).norm() > limit; })) break;
      }
    }
  }

  // Delaunay flips: the two angles opposite an edge shall not exceed 180 degrees together.
  void flip() {
    for (int a = 0; a < mesh_.vertexCount(); ++a) {
      for (int b : mesh_.ring(a)) {
        if (a > b) continue;
        const auto [left, right] = mesh_.opposite(a, b);
        if (cosine(left, a, b) + cosine(right, a, b) < 0) mesh_.flip(a, b);
      }
    }
  }

  double cosine(int apex, int a, int b) const {
    const Vec3 p = mesh_.position(a) - mesh_.position(apex), q = mesh_.position(b) - mesh_.position(apex);
    return p.dot(q) / (p.norm() * q.norm());
  }

  // Towards the centre of the ring, weighted so that large wanted edges get large triangles; then back to the surface.
  void relax() {
    Positions moved(mesh_.vertexCount());
    for (int v = 0; v < mesh_.vertexCount(); ++v) moved[v] = relaxed(v);
    for (int v = 0; v < mesh_.vertexCount(); ++v) mesh_.move(v, moved[v]);
  }

  Vec3 relaxed(int v) const {
    const std::vector<int> ring = mesh_.ring(v);
    Vec3 sum = Vec3::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int b = ring[i], c = ring[(i + 1) % ring.size()];
      const Vec3 centre = (mesh_.position(v) + mesh_.position(b) + mesh_.position(c)) / 3;
      const double area = (mesh_.position(b) - mesh_.position(v)).cross(mesh_.position(c) - mesh_.position(v)).norm();
      const double size = wanted_[v] + wanted_[b] + wanted_[c];
      const double weight = area / (size * size);
      sum += weight * centre;
      weights += weight;
    }
    const Vec3 normal = mesh_.normal(v).normalized();
    Vec3 step = sum / weights - mesh_.position(v);
    step -= normal.dot(step) * normal;
    return projectToSurface(field_, mesh_.position(v) + step, 0.01 * wanted_[v]);
  }

  EditMesh mesh_;
  const Field& field_;
  const EdgeLength& edge_;
  std::vector<double> wanted_;
};

}  // namespace

Surface remesh(Surface surface, const Field& field, const EdgeLength& edge, int rounds) {
  Remesher remesher(std::move(surface), field, edge);
  for (int i = 0; i < rounds; ++i) remesher.round();
  return remesher.take();
}

Surface makeSurface(const Body& body) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinity), high = Vec3::Constant(-infinity);
  double cell = infinity;
  for (const Limb& limb : body.limbs) {
    for (int i = 0; i < limb.jointCount(); ++i) {
      cell = std::min(cell, std::min(limb.edge, 0.9 * limb.radius[i]));
      low = low.cwiseMin(limb.centre[i] - Vec3::Constant(limb.radius[i]));
      high = high.cwiseMax(limb.centre[i] + Vec3::Constant(limb.radius[i]));
    }
  }
  const Vec3 margin = Vec3::Constant(2 * cell);
  const Field field = [&](const Vec3& p) { return fieldValue(body, p); };
  const EdgeLength edge = [&](const Vec3& p) { return wantedEdge(body, p); };
  return remesh(polygonise(field, low - margin, high + margin, cell), field, edge, 12);
}

}  // namespace shapespline
