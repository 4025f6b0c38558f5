// The GLB container: 12 bytes of header, then chunks (glTF 2.0, section 4.4).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/status.h"

namespace shapespline {

/// The JSON and BIN chunks of a GLB, as views into its bytes.
struct GlbChunks {
  std::string_view json;
  std::span<const std::uint8_t> bin;  ///< empty without a BIN chunk
  bool hasBin = false;
};

/// Whether the bytes start with GLB's magic number.
bool isGlb(std::span<const std::uint8_t> bytes);

/// Errors: TruncatedFile, MalformedFile, Unsupported (glTF 1.0).
Result<GlbChunks> splitGlb(std::span<const std::uint8_t> bytes, const std::string& where);

}  // namespace shapespline
