// Numbers in messages.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "core/base/format.h"
#include "io/base/byte_text.h"

namespace shapespline::test::format_test {

TEST_CASE("short numbers are written like printf's %.6g") {
  std::vector<double> numbers = {0,         -0.0,    1,       10,     -3,     0.1,       1.5,      123456,
                                 999999,    1000000, 1234567, 1e-4,   9.9e-5, 0.0001234, 9.999996, 99999.9,
                                 1e100,     -2e-30,  1e308,   5e-324, 0.3,    1 / 3.,    2e9,      INFINITY,
                                 -INFINITY, NAN,     100.25,  0.05,   1e21,   12.5};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> digits(-1, 1), power(-12, 12);
  for (int i = 0; i < 10000; ++i) numbers.push_back(digits(random) * std::pow(10, power(random)));
  for (const double number : numbers) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    CHECK(shortNumber(number) == text);
  }
}

TEST_CASE("sizes are written with one decimal") {
  CHECK(sizeText(1) == "1 byte");
  CHECK(sizeText(999'999) == "999,999 bytes");
  CHECK(sizeText(1'000'000) == "1.0 MB");
  CHECK(sizeText(1'250'001) == "1.3 MB");
  CHECK(sizeText(12'340'000) == "12.3 MB");
  CHECK(sizeText(4'270'000'000) == "4.3 GB");
}

}  // namespace shapespline::test::format_test
