// The mean of positions.
#pragma once

#include "core/base/types.h"

namespace shapespline {

inline Vec3 centroidOf(const Positions& positions) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : positions) sum += p;
  return sum / static_cast<double>(positions.size());
}

}  // namespace shapespline
