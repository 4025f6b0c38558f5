// Numbers that rank alternatives, made so coarse that rounding decides nothing.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace shapespline {

/// A number of at least zero to about 0.4 %, as an integer of the same order: eight bits of the mantissa are kept. The
/// factor moves the steps away from round numbers, of which regular meshes are full.
inline std::uint32_t coarse(double value) {
  const double scaled = std::max(value, 0.0) * 0.7390851332151607;
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(scaled) >> 44);
}

}  // namespace shapespline
