// A file in memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace shapespline {

/// A file given by the user. The name may contain a path relative to the given folder.
struct NamedBytes {
  std::string name;
  std::span<const std::uint8_t> bytes;
};

}  // namespace shapespline
