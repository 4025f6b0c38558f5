#include "io/base/byte_text.h"

#include "core/base/format.h"

namespace shapespline {

namespace {

struct Character {
  char32_t code;      // 0 if the bytes are invalid UTF-8
  std::size_t bytes;  // at least 1
};

// Decodes the first character of a non-empty text.
Character characterOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {0, 1};
  char32_t code = lead & (0x7f >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {0, 1};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool isSurrogate = code >= 0xd800 && code < 0xe000;
  return {code < least[bytes] || isSurrogate || code > 0x10ffff ? 0 : code, bytes};
}

// Excludes control characters, line separators and marks of the writing direction.
bool isText(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return !(within(0, 0x1f) || within(0x7f, 0x9f) || code == 0x61c || within(0x200e, 0x200f) || within(0x2028, 0x202e) ||
           within(0x2066, 0x2069) || code == 0xfeff);
}

}  // namespace

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

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::string extensionOf(std::string_view path) {
  const std::string_view name = baseName(path);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return "";
  return lowerCase(name.substr(dot + 1));
}

bool isUtf16(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 8) return false;
  if ((bytes[0] == 0xff && bytes[1] == 0xfe) || (bytes[0] == 0xfe && bytes[1] == 0xff)) return true;
  // Every second byte of ASCII in UTF-16 is 0. Names in other scripts may come before the first ASCII character.
  constexpr std::size_t looked = 256;
  const auto isText = [](std::uint8_t c) { return (c >= ' ' && c < 127) || c == '\t' || c == '\r' || c == '\n'; };
  std::size_t pairs = 0, little = 0, big = 0;
  for (std::size_t i = 0; i + 1 < bytes.size() && i < looked; i += 2, ++pairs) {
    little += isText(bytes[i]) && bytes[i + 1] == 0;
    big += bytes[i] == 0 && isText(bytes[i + 1]);
  }
  return 4 * little >= 3 * pairs || 4 * big >= 3 * pairs;
}

std::string asUtf8(std::string_view name) {
  std::string latin;
  bool isUtf8 = true;
  for (std::string_view rest = name; !rest.empty() && isUtf8;) {
    const Character first = characterOf(rest);
    isUtf8 = first.code != 0 || rest.front() == 0;
    rest.remove_prefix(first.bytes);
  }
  if (isUtf8) return std::string(name);
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80) latin += static_cast<char>(0xc0 | code >> 6);
    latin += static_cast<char>(code < 0x80 ? code : 0x80 | (code & 0x3f));
  }
  return latin;
}

std::string onOneLine(std::string_view name, char instead) {
  std::string out;
  while (!name.empty()) {
    const Character first = characterOf(name);
    if (isText(first.code)) out += name.substr(0, first.bytes);
    else out += instead;
    name.remove_prefix(first.bytes);
  }
  return out;
}

std::string inQuotes(std::string_view text) {
  constexpr int longest = 80;
  std::size_t end = 0;
  for (int count = 0; count < longest && end < text.size(); ++count) end += characterOf(text.substr(end)).bytes;
  return "\"" + onOneLine(text.substr(0, end), '?') + (end < text.size() ? "...\"" : "\"");
}

}  // namespace shapespline
