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

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string out = "\"";
  for (char c : text.substr(0, longest)) out += c >= ' ' && c < 127 ? c : '?';
  return out + (text.size() > longest ? "...\"" : "\"");
}

}  // namespace shapespline
