// Measures of one triangle.
#pragma once

#include <algorithm>

#include "core/base/types.h"

namespace shapespline {

/// Limit of twice the area over the squared longest edge. Flatter triangles have no usable normal: float32 places a
/// corner to about 1e-7 of the size, so their shape is noise.
inline constexpr double degenerateFlatness = 1e-6;

/// Also true for NaN.
inline bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const double longest = std::max(std::max(u.squaredNorm(), (v - u).squaredNorm()), v.squaredNorm());
  return !(u.cross(v).squaredNorm() > degenerateFlatness * degenerateFlatness * longest * longest);
}

/// Half the cotangent of the angle at corner c: the weight of the opposite side in the cotangent matrix.
inline double cotangentWeight(const Positions& p, const Triangle& t, int c) {
  const Vec3 u = p[t[(c + 1) % 3]] - p[t[c]], v = p[t[(c + 2) % 3]] - p[t[c]];
  return u.dot(v) / u.cross(v).norm() / 2;
}

inline Vec3 centroidOf(const Positions& p, const Triangle& f) { return (p[f[0]] + p[f[1]] + p[f[2]]) / 3; }

}  // namespace shapespline
