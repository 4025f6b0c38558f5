#include "core/hold/sliding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

// Share of the total area. A smaller area is just a few vertices that happen to reverse.
constexpr double minResting = 1e-3;

}  // namespace

Sliding::Sliding(const HoldMesh& mesh, const Curve& keys)
    : path_(mesh.shape, keys, {PathRest::WhereStill, keySize(mesh.shape)}), area_(vertexAreas(mesh)), diagonal_(0) {
  for (int key = 0; key < mesh.shape.keys; ++key) {
    const Positions* pose = &mesh.shape.poses[key];
    diagonal_ = std::max(diagonal_, boundingDiagonal({&pose, 1}));
  }
}

double Sliding::at(double t, const Positions& shape, const std::vector<int>& weldedOf) const {
  const SpanPosition inSpan = path_.spanPositionAt(t);
  Positions rests;
  path_.positionsAt(t, rests);
  double square = 0, resting = 0;
  std::vector<char> seen(area_.size(), 0);
  for (std::size_t raw = 0; raw < shape.size() && inSpan.beyond == 0; ++raw) {
    const auto v = static_cast<std::size_t>(weldedOf[raw]);
    if (seen[v]) continue;
    seen[v] = 1;
    const double weight = area_[v] * static_cast<double>(path_.rest(inSpan.span, v));
    if (weight == 0) continue;
    resting += weight;
    square += weight * (shape[raw] - rests[v]).squaredNorm();
  }
  if (resting < minResting) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(square / resting) / diagonal_;
}

}  // namespace shapespline
