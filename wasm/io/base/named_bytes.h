// A file in memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace shapespline {

/// A file as the user gave it. The name may hold a path relative to the folder that was given.
struct NamedBytes {
  std::string name;
  std::span<const std::uint8_t> bytes;
};

}  // namespace shapespline
