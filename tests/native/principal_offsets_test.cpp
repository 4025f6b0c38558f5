// A few offset fields approximate many: exactly for rows in few dimensions, otherwise within the tolerance.
#include <doctest/doctest.h>

#include <cmath>

#include "core/mesh/principal_offsets.h"

namespace shapespline::test::principal_offsets_test {

namespace {

using Rows = std::vector<std::vector<float>>;

// Two offset fields over 40 vertices, mixed by a slow and a fast wave.
Rows waves(int rows, double third = 0) {
  Rows out(rows, std::vector<float>(120));
  for (int i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / (rows - 1);
    for (int c = 0; c < 120; ++c)
      out[i][c] = static_cast<float>(std::sin(3 * t) * std::cos(0.1 * c) + 0.2 * std::sin(9 * t) * std::sin(0.3 * c) +
                                     third * std::sin(20 * t) * std::cos(0.7 * c));
  }
  return out;
}

double largestLeft(const Rows& rows, const PrincipalOffsets& p) {
  double largest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t v = 0; v < rows[i].size(); v += 3) {
      double square = 0;
      for (std::size_t c = v; c < v + 3; ++c) {
        double value = rows[i][c];
        for (int k = 0; k < p.count; ++k)
          value -= static_cast<double>(p.weights[i * p.count + k]) * p.offsets[k * rows[i].size() + c];
        square += value * value;
      }
      largest = std::max(largest, std::sqrt(square));
    }
  return largest;
}

}  // namespace

TEST_CASE("principal offsets are the fewest for the tolerance, and state the remaining error") {
  const Rows rows = waves(30, 0.001);
  for (const auto& [tolerance, count] : {std::pair(1e-5, 3), std::pair(0.01, 2), std::pair(1.0, 1)}) {
    Rows scratch = rows;
    const PrincipalOffsets p = principalOffsets(scratch, tolerance, 30);
    CHECK(p.count == count);
    CHECK(p.largest <= tolerance);
    CHECK(largestLeft(rows, p) == doctest::Approx(p.largest).epsilon(0.01).scale(1e-4));
    for (int k = 0; k < p.count; ++k) {
      float most = 0;
      for (std::size_t i = 0; i < rows.size(); ++i) most = std::max(most, std::abs(p.weights[i * p.count + k]));
      CHECK(most == doctest::Approx(1));
    }
  }
}

TEST_CASE("principal offsets are limited to the requested number, and are empty without an error") {
  Rows rows = waves(10);
  const PrincipalOffsets one = principalOffsets(rows, 0, 1);
  CHECK(one.count == 1);
  CHECK(one.largest > 0.01);
  Rows still(5, std::vector<float>(30, 0));
  CHECK(principalOffsets(still, 0, 5).count == 0);
  Rows none;
  CHECK(principalOffsets(none, 0.1, 5).count == 0);
}

}  // namespace shapespline::test::principal_offsets_test
