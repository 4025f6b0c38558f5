#include "core/patches/central_key.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

constexpr int mostFaces = 2000;
// Keys are equally central if their mean squares differ by less. Noise then does not choose between symmetric keys.
constexpr double equallyCentral = 1e-5;

// A triangle with the mean metric of a face over the keys: it favours no key.
FaceFrame commonFrame(const WeldedShape& shape, int face, int keys) {
  const Triangle& t = shape.faces[face];
  const auto edge = [&](int key, int corner) -> Vec3 { return shape.poses[key][t[corner]] - shape.poses[key][t[0]]; };
  double squares = 0, products = 0, heights = 0;
  for (int j = 0; j < keys; ++j) {
    squares += edge(j, 1).squaredNorm() / keys;
    products += edge(j, 1).dot(edge(j, 2)) / keys;
  }
  for (int j = 0; j < keys; ++j) heights += (edge(j, 2) - products / squares * edge(j, 1)).squaredNorm() / keys;
  FaceFrame frame;
  frame.basis.setIdentity();
  frame.edges << std::sqrt(squares), products / std::sqrt(squares), 0, std::sqrt(heights);
  frame.area = std::sqrt(squares * heights) / 2;
  return frame;
}

}  // namespace

int centralKey(const WeldedShape& shape, const ShapeTopology& topology) {
  const int keys = shape.keys - (shape.closing ? 1 : 0);
  const int stride = topology.usedFaces() / mostFaces + 1;
  int visited = 0;
  double total = 0;
  std::vector<double> toAll(keys, 0), toReference(keys, 0);  // sums of area times the trace of the relative rotation
  topology.eachUsedFace([&](int f) {
    if (visited++ % stride != 0) return;
    const FaceFrame frame = commonFrame(shape, f, keys);
    std::vector<Mat3> rotation;
    Mat3 sum = Mat3::Zero();
    for (int j = 0; j < keys; ++j) {
      rotation.push_back(deformationOf(shape, f, frame, j).rotation);
      sum += rotation.back();
    }
    const Mat3 reference = deformationOf(shape, f, frame, shape.reference).rotation;
    for (int j = 0; j < keys; ++j) {
      toAll[j] += frame.area * rotation[j].cwiseProduct(sum).sum();
      toReference[j] += frame.area * rotation[j].cwiseProduct(reference).sum();
    }
    total += frame.area * keys;
  });
  const double most = *std::max_element(toAll.begin(), toAll.end()) - equallyCentral * total;
  int central = -1;
  for (int j = 0; j < keys; ++j)
    if (toAll[j] >= most && (central < 0 || toReference[j] > toReference[central])) central = j;
  return central;
}

}  // namespace shapespline
