// How much a file may hold.
#pragma once

#include <cstdint>

namespace shapespline {

/// More vertices than a browser can complete; also the bound for what a file declares without bytes behind it.
constexpr std::uint64_t kMostElements = 16'000'000;

}  // namespace shapespline
