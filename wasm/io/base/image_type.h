// Image formats, recognised by their first bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace shapespline {

/// The MIME type, or "" if glTF does not support the format. Nothing is decoded.
inline std::string imageType(std::span<const std::uint8_t> bytes) {
  const auto startsWith = [&](const char* magic, std::size_t length, std::size_t at = 0) {
    return bytes.size() >= at + length && std::memcmp(bytes.data() + at, magic, length) == 0;
  };
  if (startsWith("\x89PNG\r\n\x1a\n", 8)) return "image/png";
  if (startsWith("\xff\xd8\xff", 3)) return "image/jpeg";
  if (startsWith("RIFF", 4) && startsWith("WEBP", 4, 8)) return "image/webp";
  if (startsWith("\xabKTX 20\xbb\r\n\x1a\n", 12)) return "image/ktx2";
  return "";
}

}  // namespace shapespline
