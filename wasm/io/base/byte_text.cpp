#include "io/base/byte_text.h"

#include <cstdio>

#include "core/base/format.h"

namespace shapespline {

std::string sizeText(std::uint64_t bytes) {
  if (bytes < 1'000'000) return grouped(static_cast<std::int64_t>(bytes)) + (bytes == 1 ? " byte" : " bytes");
  const bool giga = bytes >= 1'000'000'000;
  char text[32];
  std::snprintf(text, sizeof text, giga ? "%.1f GB" : "%.1f MB", static_cast<double>(bytes) / (giga ? 1e9 : 1e6));
  return text;
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
