#include "core/patches/central_key.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

constexpr int maxFaces = 500;
// Weights relative to all keys. Between equally central keys, as two are, the one with the larger area decides; between
// keys of equal area, the reference instead of noise.
constexpr double areaWeight = 1e-4;
constexpr double referenceWeight = 1e-6;

double areaOf(const Positions& p, const Triangle& t) { return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm(); }

// A triangle with mean edges and area of a face: it favours no key.
FaceFrame commonFrame(const WeldedShape& shape, const Triangle& t, int keys) {
  double squares = 0, products = 0, areas = 0;
  for (int j = 0; j < keys; ++j) {
    const Positions& p = shape.poses[j];
    const Vec3 b = p[t[1]] - p[t[0]], c = p[t[2]] - p[t[0]];
    squares += b.squaredNorm() / keys;
    products += b.dot(c) / keys;
    areas += b.cross(c).squaredNorm() / keys;
  }
  FaceFrame frame;
  frame.basis.setIdentity();
  frame.edges << std::sqrt(squares), products / std::sqrt(squares), 0, std::sqrt(areas / squares);
  frame.area = std::sqrt(areas);
  return frame;
}

}  // namespace

int centralKey(const WeldedShape& shape, const ShapeTopology& topology) {
  const int keys = shape.keys - (shape.closing ? 1 : 0);
  const int stride = topology.usedFaces() / maxFaces + 1;
  int visited = 0;
  std::vector<double> agreement(keys, 0);  // sum of cos^2 of half the relative angles
  std::vector<Quaternion> rotation(keys);
  topology.eachUsedFace([&](int f) {
    if (visited++ % stride != 0) return;
    const FaceFrame frame = commonFrame(shape, shape.faces[f], keys);
    for (int j = 0; j < keys; ++j) rotation[j] = Quaternion(deformationOf(shape, f, frame, j).rotation);
    const Quaternion& reference = rotation[shape.reference % keys];
    for (int j = 0; j < keys; ++j) {
      double sum = referenceWeight * keys * std::pow(rotation[j].dot(reference), 2);
      for (const Quaternion& other : rotation) sum += std::pow(rotation[j].dot(other), 2);
      agreement[j] += frame.area * sum + areaWeight * keys * areaOf(shape.poses[j], shape.faces[f]);
    }
  });
  return static_cast<int>(std::max_element(agreement.begin(), agreement.end()) - agreement.begin());
}

}  // namespace shapespline
