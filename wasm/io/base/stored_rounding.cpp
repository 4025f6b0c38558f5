#include "io/base/stored_rounding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace shapespline {

double storedRounding(const Positions& positions) {
  Vec3 largest = Vec3::Zero();
  for (const Vec3& p : positions)
    for (int c = 0; c < 3; ++c) {
      const auto number = static_cast<float>(p[c]);
      if (static_cast<double>(number) != p[c]) return 0;
      const bool usesLastBit = (std::bit_cast<std::uint32_t>(number) & 1) != 0;
      if (usesLastBit) largest[c] = std::max<double>(largest[c], std::abs(number));
    }
  Vec3 halfSteps;
  for (int c = 0; c < 3; ++c) halfSteps[c] = largest[c] > 0 ? std::ldexp(1.0, std::ilogb(largest[c]) - 24) : 0;
  return halfSteps.norm();
}

}  // namespace shapespline
