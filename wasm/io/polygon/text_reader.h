// Reads lines, words and numbers of text files, without streams or locale.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/progress.h"

namespace shapespline {

/// Splits a text into lines. Lines may end with LF, CRLF or CR. A byte order mark is skipped.
class LineReader {
 public:
  explicit LineReader(std::span<const std::uint8_t> bytes)
      : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  /// Reads the next line without its end. Returns false at the end of the text.
  bool next(std::string_view& line);

  std::int64_t lineNumber() const { return number_; }  ///< number of the last line, from 1
  std::string_view rest() const { return rest_; }      ///< the text after the last line

 private:
  std::string_view rest_;
  std::int64_t number_ = 0;
};

/// Reports at intervals which part of a text of `size` bytes has been read.
inline void reportLine(const FractionReport& report, const LineReader& lines, std::size_t size) {
  if (lines.lineNumber() % 16384 == 0)
    reportFraction(report, 1 - static_cast<double>(lines.rest().size()) / static_cast<double>(size));
}

/// Removes the next word, delimited by white space, from the front of `text`; empty if there is none.
std::string_view takeWord(std::string_view& text);

/// Reads a decimal number. If the next word is not a number, returns false and leaves `text` unchanged. Accepts nan and
/// inf.
bool takeNumber(std::string_view& text, double& value);

/// Reads a whole number at the very front of `text`, up to the first non-digit.
bool takeInteger(std::string_view& text, std::int64_t& value);

/// Whether the next word is a number with commas, or a comma.
bool hasDecimalComma(std::string_view text);

/// Parses a word that must be one number.
bool parseNumber(std::string_view word, double& value);

}  // namespace shapespline
