#include "io/polygon/text_reader.h"

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

namespace shapespline {

namespace {

constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Handles all cases outside the fast path below: many digits, large exponents, nan, inf.
bool slowNumber(std::string_view word, double& value) {
  char buffer[128];
  if (word.empty() || word.size() >= sizeof buffer) return false;
  if (word.find(".#") != std::string_view::npos) {  // 1.#QNAN and -1.#IND, as older Windows programs write NaN
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  std::memcpy(buffer, word.data(), word.size());
  buffer[word.size()] = 0;
  char* end = nullptr;
  value = std::strtod(buffer, &end);
  return end == buffer + word.size();
}

}  // namespace

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find_first_of("\r\n");
  line = rest_.substr(0, end);
  ++number_;
  if (end == std::string_view::npos) {
    rest_ = {};
    return true;
  }
  const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
  rest_.remove_prefix(end + (pair ? 2 : 1));
  return true;
}

std::string_view takeWord(std::string_view& text) {
  std::size_t start = 0;
  while (start < text.size() && isBlank(text[start])) ++start;
  std::size_t end = start;
  while (end < text.size() && !isBlank(text[end])) ++end;
  const std::string_view word = text.substr(start, end - start);
  text.remove_prefix(end);
  return word;
}

// A mantissa below 2^53 times or over a power of ten up to 22 is correctly rounded in one step (Clinger 1990). Some
// libraries still lack C++'s from_chars for floating point, and strtod is slow where long double is emulated.
bool parseNumber(std::string_view word, double& value) {
  std::size_t at = 0;
  const bool negative = !word.empty() && word[0] == '-';
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) ++at;
  std::uint64_t mantissa = 0;
  int digits = 0, exponent = 0;
  for (; at < word.size() && isDigit(word[at]); ++at, ++digits)
    if (digits < 19) mantissa = 10 * mantissa + (word[at] - '0');
  if (at < word.size() && word[at] == '.')
    for (++at; at < word.size() && isDigit(word[at]); ++at, ++digits)
      if (digits < 19) {
        mantissa = 10 * mantissa + (word[at] - '0');
        --exponent;
      }
  if (digits == 0 || digits > 19) return slowNumber(word, value);
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    std::string_view rest = word.substr(at + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    std::int64_t written = 0;
    if (!takeInteger(rest, written) || !rest.empty() || written < -400 || written > 400) return slowNumber(word, value);
    exponent += static_cast<int>(written);
    at = word.size();
  }
  if (at != word.size() || mantissa > (1ull << 53) || exponent < -22 || exponent > 22) return slowNumber(word, value);
  value = static_cast<double>(mantissa);
  value = exponent < 0 ? value / powers[-exponent] : value * powers[exponent];
  if (negative) value = -value;
  return true;
}

bool takeNumber(std::string_view& text, double& value) {
  std::string_view rest = text;
  if (!parseNumber(takeWord(rest), value)) return false;
  text = rest;
  return true;
}

bool hasDecimalComma(std::string_view text) {
  std::string word(takeWord(text).substr(0, 64));
  if (std::erase(word, ',') == 0) return false;
  double value;
  return word.empty() || parseNumber(word, value);
}

bool takeInteger(std::string_view& text, std::int64_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(end - text.data());
  return true;
}

}  // namespace shapespline
