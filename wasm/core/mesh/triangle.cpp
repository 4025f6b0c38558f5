#include "core/mesh/triangle.h"

#include <algorithm>

namespace shapespline {

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double doubleArea = (b - a).cross(c - a).norm();
  return !(doubleArea > degenerateFlatness * longest);  // also true for NaN
}

}  // namespace shapespline
