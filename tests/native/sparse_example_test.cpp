// The example of wasm/core/sparse/README.md.
#include <doctest/doctest.h>

#include "core/sparse/cholesky.h"

namespace shapespline::test::sparse_example_test {

TEST_CASE("sparse: a small system, as in the README") {
  const std::vector<Triplet> entries = {{0, 0, 4}, {1, 0, -1}, {1, 1, 4}, {2, 1, -1}, {2, 2, 4}};
  const SymmetricMatrix matrix = assembleSymmetric(3, entries);

  Cholesky solver;
  Status status = solver.analyse(matrix, {}, Precision::Double);
  if (status.ok()) status = solver.factorise(matrix);
  REQUIRE(status.ok());

  std::vector<double, Eigen::aligned_allocator<double>> x(4 * static_cast<std::size_t>(solver.paddedSize()));
  const auto at = [&](int i) -> double& { return x[4 * static_cast<std::size_t>(solver.eliminationPosition()[i])]; };
  for (int i = 0; i < 3; ++i) at(i) = 1;
  solver.solve(x.data());
  CHECK(at(0) == doctest::Approx(5.0 / 14));
  CHECK(at(1) == doctest::Approx(6.0 / 14));
  CHECK(at(2) == doctest::Approx(5.0 / 14));
}

}  // namespace shapespline::test::sparse_example_test
