// Formats sizes and names for error messages about files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace shapespline {

/// Examples: 812 bytes, 3.1 MB, 2.4 GB.
std::string sizeText(std::uint64_t bytes);

/// The part of a path after its last slash.
std::string_view baseName(std::string_view path);

/// With A to Z in lower case.
std::string lowerCase(std::string_view text);

/// The lower-case extension without its dot, or "".
std::string extensionOf(std::string_view path);

/// Completes an error message about a file.
constexpr const char* utf16 = " is text in UTF-16, which is not supported. Save it as UTF-8.";
/// Whether the bytes are text in UTF-16, with a byte order mark or without.
bool isUtf16(std::span<const std::uint8_t> bytes);

/// A name as UTF-8. Bytes that are not UTF-8 are read as Latin-1, which older programs write.
std::string asUtf8(std::string_view name);

/// A name on one line: control characters, line separators, marks of the writing direction and invalid bytes become
/// `instead`.
std::string onOneLine(std::string_view name, char instead = ' ');

/// Makes text from an untrusted file safe for a message: at most 80 characters in UTF-8, on one line with '?'.
std::string inQuotes(std::string_view text);

}  // namespace shapespline
