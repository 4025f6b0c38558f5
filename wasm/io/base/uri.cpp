#include "io/base/uri.h"

#include <array>
#include <optional>

#include "io/base/byte_text.h"

namespace shapespline {

namespace {

constexpr const char* onlyGiven =
    "Save that file in the same folder, change the reference to its name, and give both together.";

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
    if (!escape) {
      out += text[i];
      continue;
    }
    out += static_cast<char>(16 * hexDigit(text[i + 1]) + hexDigit(text[i + 2]));
    i += 2;
  }
  return out;
}

constexpr std::array<std::int16_t, 256> makeBase64Table() {
  std::array<std::int16_t, 256> table{};
  for (auto& value : table) value = -1;
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int i = 0; i < 64; ++i) table[static_cast<unsigned char>(digits[i])] = static_cast<std::int16_t>(i);
  return table;
}
constexpr std::array<std::int16_t, 256> base64Mark = makeBase64Table();

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// White space is ignored, as in browsers.
std::optional<std::vector<std::uint8_t>> base64Decoded(std::string_view text) {
  while (!text.empty() && (text.back() == '=' || isSpace(text.back()))) text.remove_suffix(1);
  std::vector<std::uint8_t> out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int have = 0;
  for (char c : text) {
    if (isSpace(c)) continue;
    const int value = base64Mark[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    have += 6;
    if (have >= 8) out.push_back(static_cast<std::uint8_t>(bits >> (have -= 8)));
  }
  return out;
}

// data:[mime][;parameters][;base64],content (RFC 2397)
Result<Resource> dataResource(std::string_view uri, const std::string& where) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos)
    return Error{ErrorCode::MalformedFile, where + " has a data URI without content. Export it again."};
  const std::string_view head = uri.substr(5, comma - 5);
  const std::string_view body = uri.substr(comma + 1);
  Resource resource;
  resource.mimeType = head.substr(0, head.find(';'));
  if (head.ends_with(";base64")) {
    auto bytes = base64Decoded(body.find('%') == std::string_view::npos ? body : percentDecoded(body));
    if (!bytes)
      return Error{ErrorCode::MalformedFile, where + " has a data URI that is not valid base64. Export it again."};
    resource.owned = std::move(*bytes);
  } else {
    const std::string text = percentDecoded(body);
    resource.owned.assign(text.begin(), text.end());
  }
  resource.bytes = resource.owned;
  return resource;
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The start of a URI, long enough for a scheme. Leading spaces and line breaks are removed, as in browsers.
std::string headOf(std::string_view uri) {
  constexpr std::size_t uriHead = 64;
  while (!uri.empty() && static_cast<unsigned char>(uri.front()) <= ' ') uri.remove_prefix(1);
  std::string head;
  for (char c : uri.substr(0, uriHead))
    if (c != '\t' && c != '\n' && c != '\r') head += c;
  return head;
}

// A letter, then letters, digits, +, - and ., then a colon (RFC 3986). A single letter is a Windows drive.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || !isLetter(uri.front())) return false;
  for (char c : uri.substr(0, colon))
    if (!isLetter(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') return false;
  return true;
}

}  // namespace

Result<Resource> resolveUri(std::string_view uri, std::string_view from, const SourceFiles& files,
                            const std::string& where) {
  if (uri.starts_with("data:")) return dataResource(uri, where);
  const std::string head = headOf(uri);
  if (head.starts_with("//") || (hasScheme(head) && head.find(':') > 1))
    return Error{ErrorCode::ExternalResource,
                 where + " refers to " + inQuotes(uri) + ". Only the given files are read. " + onlyGiven};
  const std::string path = percentDecoded(uri);
  const std::string start = headOf(path);
  const bool absolute = start.starts_with('/') || start.starts_with('\\') || hasScheme(start);
  if (!absolute)
    if (const NamedBytes* file = files.find(path, from)) {
      Resource resource;
      resource.bytes = file->bytes;
      return resource;
    }
  if (absolute || leavesItsFolder(path))
    return Error{ErrorCode::ExternalResource,
                 where + " refers to " + inQuotes(uri) + ", which is outside the given files. " + onlyGiven};
  return Error{ErrorCode::MissingResource,
               where + " needs the file " + inQuotes(uri) + ", which was not given. Give both files together."};
}

}  // namespace shapespline
