// Compares lines and numbers of text files with the C library.
#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "io/polygon/text_reader.h"

namespace shapespline::test::text_reader_test {

TEST_CASE("numbers equal those of the C library, bit for bit") {
  std::vector<std::string> words{"0",
                                 "-0",
                                 "1",
                                 "+1",
                                 ".5",
                                 "5.",
                                 "1e3",
                                 "1E-3",
                                 "1e+22",
                                 "1e23",
                                 "123456789012345678",
                                 "9007199254740993",
                                 "0.1234567890123456789012345",
                                 "1e-400",
                                 "1e400",
                                 "4.9e-324",
                                 "1.7976931348623157e308",
                                 "-0.0000001"};
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    char text[64];
    words.emplace_back(text,
                       std::to_chars(text, text + sizeof text, i % 2 ? value : std::remainder(value, 1000.0)).ptr);
    words.emplace_back(text,
                       std::to_chars(text, text + sizeof text, static_cast<float>(random() % 1000000) / 1000.0f).ptr);
  }
  int wrong = 0;
  for (const std::string& word : words) {
    double value = -1;
    if (!parseNumber(word, value) || value != std::strtod(word.c_str(), nullptr)) {
      ++wrong;
      MESSAGE(word);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("texts that are not numbers") {
  double value = 0;
  for (const char* word : {"", "-", "+", ".", "e5", "1e", "1e+", "1x", "0x", "1,5", "--1", "1e5.5"}) {
    CAPTURE(word);
    CHECK(!parseNumber(word, value));
  }
  CHECK(parseNumber("nan", value));
  CHECK(std::isnan(value));
  CHECK(parseNumber("-inf", value));
  CHECK(std::isinf(value));
}

TEST_CASE("words are read one by one") {
  std::string_view text = "  v 1.5\t-2 x";
  double value = 0;
  CHECK(takeWord(text) == "v");
  CHECK(takeNumber(text, value));
  CHECK(value == 1.5);
  CHECK(takeNumber(text, value));
  CHECK(value == -2);
  CHECK(!takeNumber(text, value));
  CHECK(takeWord(text) == "x");
  CHECK(takeWord(text).empty());
}

TEST_CASE("lines can have any line ends") {
  const std::string text = "a\nb\r\nc\rd\n\ne";
  LineReader lines(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  std::string all;
  std::string_view line;
  while (lines.next(line)) all += std::string(line) + "|";
  CHECK(all == "a|b|c|d||e|");
  CHECK(lines.lineNumber() == 6);
}

}  // namespace shapespline::test::text_reader_test
