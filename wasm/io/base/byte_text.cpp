#include "io/base/byte_text.h"

#include "core/base/format.h"

namespace shapespline {

std::string sizeText(std::uint64_t bytes) {
  if (bytes < 1'000'000) return grouped(static_cast<std::int64_t>(bytes)) + (bytes == 1 ? " byte" : " bytes");
  const bool giga = bytes >= 1'000'000'000;
  const std::uint64_t tenth = giga ? 100'000'000 : 100'000, tenths = bytes / tenth + (bytes % tenth >= tenth / 2);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + (giga ? " GB" : " MB");
}

std::string_view baseName(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string extensionOf(std::string_view path) {
  const std::string_view name = baseName(path);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return "";
  std::string extension(name.substr(dot + 1));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

bool isUtf16(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 8) return false;
  if ((bytes[0] == 0xff && bytes[1] == 0xfe) || (bytes[0] == 0xfe && bytes[1] == 0xff)) return true;
  // Of ASCII characters every other byte is 0; a name in another script may stand between them.
  constexpr std::size_t looked = 256;
  const auto isText = [](std::uint8_t c) { return (c >= ' ' && c < 127) || c == '\t' || c == '\r' || c == '\n'; };
  std::size_t pairs = 0, little = 0, big = 0;
  for (std::size_t i = 0; i + 1 < bytes.size() && i < looked; i += 2, ++pairs) {
    little += isText(bytes[i]) && bytes[i + 1] == 0;
    big += bytes[i] == 0 && isText(bytes[i + 1]);
  }
  return 4 * little >= 3 * pairs || 4 * big >= 3 * pairs;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string out = "\"";
  for (char c : text.substr(0, longest)) out += c >= ' ' && c < 127 ? c : '?';
  return out + (text.size() > longest ? "...\"" : "\"");
}

}  // namespace shapespline
