// Pins of each kind on the limbs of any shape.
#pragma once

#include <algorithm>
#include <vector>

#include "core/base/centroid.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "shapes.h"

namespace shapespline::test {

/// Vertices far from the centroid of the first key and from each other.
inline std::vector<int> limbs(const Keyframes& k, int count) {
  const Positions& p = k.keys[0].positions;
  Positions others = {centroidOf(p)};
  std::vector<int> found;
  for (int i = 0; i < count; ++i) {
    double farthest = -1;
    for (std::size_t v = 0; v < p.size(); ++v) {
      double near = 1e300;
      for (const Vec3& other : others) near = std::min(near, (p[v] - other).norm());
      if (near > farthest) farthest = near, found.resize(i), found.push_back(static_cast<int>(v));
    }
    others.push_back(p[found.back()]);
  }
  return found;
}

/// A ball on its own splines, a patch that keeps its position from the second key, and a ball that moves by 3 % of the
/// diagonal to either side.
inline std::vector<Pin> everyPin(const Keyframes& k) {
  const std::vector<int> at = limbs(k, 3);
  const double first = k.keys.front().time, length = k.keys.back().time - first, way = 0.03 * diagonalOf(k);
  return {
      {at[0], 0.06, -1},
      {at[1], 0, 1},
      {at[2], 0.06, -1, {{first + 0.2 * length, way * Vec3::UnitX()}, {first + 0.7 * length, way * Vec3(0, -1, 0.5)}}}};
}

}  // namespace shapespline::test
