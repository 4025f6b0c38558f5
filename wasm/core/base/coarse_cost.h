// Coarse numbers for ranking, so rounding never decides.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace shapespline {

/// Rounds a non-negative number to about 0.4 % and returns an order-preserving integer with eight bits of the mantissa.
/// The factor moves the steps away from round numbers, which are frequent in regular meshes.
inline std::uint32_t coarse(double value) {
  const double scaled = std::max(value, 0.0) * 0.7390851332151607;
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(scaled) >> 44);
}

}  // namespace shapespline
