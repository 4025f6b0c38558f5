#include "core/sequence/mirrored_keys.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace shapespline {

namespace {

// A sample of this size suffices.
constexpr int sampledVertices = 50000;
// Total curvature of all domes (a sphere has 4 pi) below which they are inconclusive.
constexpr double minCurvature = 1;
// Boundary vertices squared over all vertices. From a disc on, which has slightly less than 4 pi, the shape is a sheet.
constexpr double sheetBoundary = 11;
// Poses of animals and people agree to 0.77 or more, a ball with growing spikes to 0.04. Their mirror images have the
// opposite sign.
constexpr double mirroredAgreement = -0.5;

// Properties of the surface around a vertex, from its faces.
struct Surroundings {
  double cosine = 1, sine = 0;                         // direction of the sum of the angles ...
  int turns = 0;                                       // ... and its number of full turns
  Vec3 towards = Vec3::Zero(), normal = Vec3::Zero();  // sums over neighbours and over faces
  int faces = 0;
  std::int64_t open = 0;  // next neighbours minus previous ones: 0 around a closed, consistently oriented fan

  void add(const Positions& p, int v, int next, int before) {
    const Vec3 a = p[next] - p[v], b = p[before] - p[v], cross = a.cross(b);
    turn(a.dot(b), cross.norm());
    towards += a + b;
    normal += cross;
    ++faces;
    open += next - before;
  }

  // Adds the angle of (x, y), at most half a turn. A complex product takes a fifth of an arc tangent's time.
  void turn(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return;
    const double before = sine, c = cosine;
    cosine = (c * x - before * y) / length;
    sine = (before * x + c * y) / length;
    turns += before < 0 && sine >= 0;
  }

  double angle() const {
    const double rest = std::atan2(sine, cosine);
    return 2 * std::numbers::pi * (turns + (rest < 0)) + rest;
  }

  bool isOnBoundary() const { return open != 0; }

  // Integral of the Gaussian curvature, negative if the dome opens to the front of the faces; 0 without a dome.
  double bulge() const {
    const double defect = 2 * std::numbers::pi - angle();
    if (faces == 0 || isOnBoundary() || !(defect > 0)) return 0;
    return towards.dot(normal) < 0 ? defect : -defect;
  }
};

// The sampled vertices, every stride-th, and their corners: c of face f as 3 f + c.
struct SampledVertices {
  explicit SampledVertices(const WeldedShape& shape) : stride(1 + shape.vertexCount() / sampledVertices) {
    inBlocks({}, shape.faces.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        for (int c = 0; c < 3; ++c)
          if (shape.faces[f][c] % stride == 0) corners.push_back(3 * static_cast<int>(f) + c);
    });
  }

  int stride;
  std::vector<int> corners;
};

// Bulges of all sampled vertices; zero for a sheet.
std::vector<double> bulges(const WeldedShape& shape, int key, const SampledVertices& sampled) {
  std::vector<Surroundings> around(shape.vertexCount() / sampled.stride + 1);
  inBlocks({}, sampled.corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Triangle& t = shape.faces[sampled.corners[i] / 3];
      const int c = sampled.corners[i] % 3;
      around[t[c] / sampled.stride].add(shape.poses[key], t[c], t[(c + 1) % 3], t[(c + 2) % 3]);
    }
  });
  std::vector<double> result;
  double used = 0, boundary = 0;
  for (const Surroundings& s : around) {
    used += s.faces > 0;
    boundary += s.isOnBoundary();
    result.push_back(s.bulge());
  }
  if (sampled.stride * boundary * boundary > sheetBoundary * used) std::fill(result.begin(), result.end(), 0);
  return result;
}

double agreement(const std::vector<double>& a, const std::vector<double>& b, int stride) {
  double sum = 0, common = 0, mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double both = std::min(std::abs(a[i]), std::abs(b[i]));
    sum += a[i] * b[i] > 0 ? both : -both;
    common += both;
    mean += (std::abs(a[i]) + std::abs(b[i])) / 2;
  }
  return stride * common >= minCurvature ? sum / mean : 1;
}

}  // namespace

double bulgeAgreement(const WeldedShape& shape, int key, int otherKey) {
  const SampledVertices sampled(shape);
  return agreement(bulges(shape, key, sampled), bulges(shape, otherKey, sampled), sampled.stride);
}

std::vector<int> mirroredKeys(const WeldedShape& shape) {
  const SampledVertices sampled(shape);
  const std::vector<double> reference = bulges(shape, shape.reference, sampled);
  std::vector<int> sides[2];
  for (int key = 0; key < shape.keys; ++key) {
    const bool isOther =
        key != shape.reference && agreement(reference, bulges(shape, key, sampled), sampled.stride) < mirroredAgreement;
    sides[isOther].push_back(key);
  }
  return sides[sides[1].size() <= sides[0].size()];
}

}  // namespace shapespline
