// Lines, words and numbers of text files, without streams or locale.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/progress.h"

namespace shapespline {

/// Takes a text from the front, line by line. Line ends may be LF, CRLF or CR; a byte order mark is skipped.
class LineReader {
 public:
  explicit LineReader(std::span<const std::uint8_t> bytes)
      : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  /// The next line without its end; false at the end of the text.
  bool next(std::string_view& line);

  std::int64_t lineNumber() const { return number_; }  ///< of the last line, from 1
  std::string_view rest() const { return rest_; }      ///< behind the last line

 private:
  std::string_view rest_;
  std::int64_t number_ = 0;
};

/// Reports now and then how much of a text of `size` bytes has been read.
inline void reportLine(const FractionReport& report, const LineReader& lines, std::size_t size) {
  if (lines.lineNumber() % 16384 == 0)
    reportFraction(report, 1 - static_cast<double>(lines.rest().size()) / static_cast<double>(size));
}

/// Takes the next word, delimited by white space, off the front of `text`; empty if there is none.
std::string_view takeWord(std::string_view& text);

/// Takes a decimal number; false, with `text` unchanged, if the next word is not one. Accepts nan and inf.
bool takeNumber(std::string_view& text, double& value);

/// Takes a whole number at the very front of `text`, up to the first non-digit.
bool takeInteger(std::string_view& text, std::int64_t& value);

/// Whether the next word is a number with a decimal comma.
bool hasDecimalComma(std::string_view text);

/// Whether a whole word is one number, and which.
bool parseNumber(std::string_view word, double& value);

}  // namespace shapespline
