// Compares the prefactored solver with Eigen. Also checks that chunks do not affect the bits and that errors name the
// unknown.
#include "core/sparse/cholesky.h"

#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>
#include <cstring>
#include <limits>
#include <type_traits>

#include "laplacian_meshes.h"

namespace shapespline::test::cholesky_test {

namespace {

constexpr std::int64_t much = std::int64_t{1} << 40;

Eigen::SparseMatrix<double> lowerTriangle(const SymmetricMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int c = 0; c < matrix.size; ++c)
    for (int i = matrix.columnStart[c]; i < matrix.columnStart[c + 1]; ++i)
      triplets.emplace_back(matrix.row[i], c, matrix.value[i]);
  Eigen::SparseMatrix<double> result(matrix.size, matrix.size);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

Eigen::MatrixX3d randomRightHandSide(int size, Random& random) {
  Eigen::MatrixX3d b(size, 3);
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < 3; ++k) b(i, k) = random.signedUnit();
  return b;
}

// Scatters into elimination order, solves, gathers. Scratch and the fourth lane start with garbage.
template <class Scalar>
Eigen::MatrixX3d solve(const Cholesky& cholesky, const Eigen::MatrixX3d& b) {
  std::vector<Scalar> x(4 * static_cast<std::size_t>(cholesky.paddedSize()), Scalar(7));
  const auto position = cholesky.eliminationPosition();
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(position[i]) + k] = static_cast<Scalar>(b(i, k));
  cholesky.solve(x.data());
  Eigen::MatrixX3d result(b.rows(), 3);
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = x[4 * static_cast<std::size_t>(position[i]) + k];
  return result;
}

Eigen::MatrixX3d eigenSolution(const SymmetricMatrix& matrix, const Eigen::MatrixX3d& b) {
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> reference(lowerTriangle(matrix));
  REQUIRE(reference.info() == Eigen::Success);
  return reference.solve(b);
}

// Largest difference relative to the extent of the expected solution.
double relativeError(const Eigen::MatrixX3d& actual, const Eigen::MatrixX3d& expected) {
  const double extent = (expected.colwise().maxCoeff() - expected.colwise().minCoeff()).norm();
  return (actual - expected).rowwise().norm().maxCoeff() / extent;
}

Cholesky factorised(const SymmetricMatrix& matrix, std::span<const Vec3> coordinates, Precision precision) {
  Cholesky cholesky;
  REQUIRE(cholesky.analyse(matrix, coordinates, precision).ok());
  REQUIRE(cholesky.factorise(matrix).ok());
  return cholesky;
}

// Compares double and single solutions of a random right-hand side with Eigen's.
void checkAgainstEigen(const SymmetricMatrix& matrix, std::span<const Vec3> coordinates, double doubleTolerance,
                       double singleTolerance) {
  Random random(matrix.size);
  const Eigen::MatrixX3d b = randomRightHandSide(matrix.size, random);
  const Eigen::MatrixX3d expected = eigenSolution(matrix, b);
  const Cholesky full = factorised(matrix, coordinates, Precision::Double);
  const Cholesky single = factorised(matrix, coordinates, Precision::Single);
  CHECK(full.stats().regularisedPivots == 0);
  CHECK(relativeError(solve<double>(full, b), expected) < doubleTolerance);
  CHECK(relativeError(solve<float>(single, b), expected) < singleTolerance);
}

SymmetricMatrix randomDefinite(int size, int entriesPerRow, Random& random) {
  std::vector<Triplet> triplets;
  std::vector<double> rowSum(size, 0.0);
  for (int i = 0; i < size * entriesPerRow; ++i) {
    const int a = random.below(size), b = random.below(size);
    const double value = random.signedUnit();
    if (a == b) continue;
    triplets.push_back({std::max(a, b), std::min(a, b), value});
    rowSum[a] += std::abs(value);
    rowSum[b] += std::abs(value);
  }
  for (int i = 0; i < size; ++i) triplets.push_back({i, i, rowSum[i] + 0.1});  // diagonally dominant
  return assembleSymmetric(size, triplets);
}

// The matrix is destroyed before the first chunk.
std::vector<double> fullSolveBits(SymmetricMatrix matrix, std::int64_t chunk) {
  const int size = matrix.size;
  Cholesky cholesky;
  REQUIRE(cholesky.analyse(matrix, {}, Precision::Double).ok());
  REQUIRE(cholesky.beginFactorise(matrix).ok());
  matrix = {};
  double last = cholesky.factoriseProgress();
  CHECK(last == 0.0);
  bool monotone = true;
  while (cholesky.factoriseSome(chunk)) {
    monotone = monotone && cholesky.factoriseProgress() >= last && cholesky.factoriseProgress() <= 1.0;
    last = cholesky.factoriseProgress();
  }
  CHECK(monotone);
  CHECK(cholesky.factoriseProgress() == 1.0);
  REQUIRE(cholesky.factoriseStatus().ok());
  std::vector<double> x(4 * static_cast<std::size_t>(cholesky.paddedSize()), 0.0);
  Random random(3);
  for (int i = 0; i < 4 * size; ++i) x[i] = random.signedUnit();
  cholesky.solve(x.data());
  x.resize(4 * static_cast<std::size_t>(size));
  return x;
}

}  // namespace

static_assert(!std::is_copy_constructible_v<Cholesky> && std::is_nothrow_move_constructible_v<Cholesky>);

TEST_CASE("cholesky: random definite matrices agree with Eigen") {
  Random random(1);
  for (int size : {1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 100, 301})
    for (int entries : {0, 1, 2, 6}) {
      CAPTURE(size);
      CAPTURE(entries);
      const SymmetricMatrix matrix = randomDefinite(size, entries, random);
      const Eigen::MatrixX3d b = randomRightHandSide(size, random);
      const Eigen::MatrixX3d expected = eigenSolution(matrix, b);
      const double scale = expected.cwiseAbs().maxCoeff();
      CHECK((solve<double>(factorised(matrix, {}, Precision::Double), b) - expected).cwiseAbs().maxCoeff() <
            1e-13 * scale);
      CHECK((solve<float>(factorised(matrix, {}, Precision::Single), b) - expected).cwiseAbs().maxCoeff() <
            1e-5 * scale);
    }
}

TEST_CASE("cholesky: a dense matrix is one supernode of full and partial panels") {
  Random random(2);
  for (const int size : {2, 3, 4, 5, 8, 63, 64, 65, 150, 203}) {
    CAPTURE(size);
    std::vector<Triplet> triplets;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c <= r; ++c) triplets.push_back({r, c, r == c ? size + 1.0 : random.signedUnit()});
    checkAgainstEigen(assembleSymmetric(size, triplets), {}, 1e-13, 1e-5);
  }
}

TEST_CASE("cholesky: dense blocks with common rows agree with Eigen, for all sizes") {
  Random random(8);
  for (const int pivots : {1, 4, 6, 33})
    for (const int rows : {1, 4, 7, 50}) {
      CAPTURE(pivots);
      CAPTURE(rows);
      const int size = 2 * pivots + rows;
      std::vector<Triplet> triplets;
      for (int r = 0; r < size; ++r)
        for (int c = 0; c <= r; ++c)
          if (r < pivots || c >= pivots || r >= 2 * pivots)  // the blocks are coupled only by the shared rows
            triplets.push_back({r, c, r == c ? size + 1.0 : random.signedUnit()});
      checkAgainstEigen(assembleSymmetric(size, triplets), {}, 1e-13, 1e-5);
    }
}

TEST_CASE("cholesky: mesh Laplacians with shuffled vertices agree with Eigen") {
  Random random(4);
  PlainMesh sheet = irregularSheet(61, 47, random), sphere = bumpySphere(22, random);
  for (PlainMesh* mesh : {&sheet, &sphere}) {
    shuffleVertices(*mesh, random);
    const SymmetricMatrix matrix = pinnedLaplacian(*mesh);
    // Limits allow for a condition number of about 1e4.
    checkAgainstEigen(matrix, mesh->positions, 1e-10, 1e-3);
    checkAgainstEigen(matrix, {}, 1e-10, 1e-3);
  }
}

TEST_CASE("cholesky: a smooth solution stays accurate with single precision storage") {
  Random random(5);
  PlainMesh mesh = bumpySphere(40, random);
  shuffleVertices(mesh, random);
  const SymmetricMatrix matrix = pinnedLaplacian(mesh);
  Eigen::MatrixX3d positions(matrix.size, 3);
  for (int v = 0; v < matrix.size; ++v) positions.row(v) = mesh.positions[v];
  const Eigen::MatrixX3d b = lowerTriangle(matrix).selfadjointView<Eigen::Lower>() * positions;
  const double error = relativeError(solve<float>(factorised(matrix, mesh.positions, Precision::Single), b), positions);
  MESSAGE("single-precision error of reconstructed vertices, relative to the extent: " << error);
  CHECK(error < 1e-5);
}

TEST_CASE("cholesky: several components, isolated unknowns and a dense row") {
  Random random(6);
  const PlainMesh part = irregularSheet(20, 20, random);
  std::vector<Triplet> triplets;
  int size = 0;
  std::vector<Vec3> coordinates;
  for (int copy = 0; copy < 7; ++copy) {
    for (Triplet t : cotangentTriplets(part)) triplets.push_back({t.row + size, t.column + size, t.value});
    triplets.push_back({size, size, 1.0});
    for (const Vec3& p : part.positions) coordinates.push_back(p + Vec3(30.0 * copy, 0, 0));
    size += 400;
  }
  for (int i = 0; i < 5; ++i) {
    triplets.push_back({size, size, 1.0 + i});
    coordinates.push_back(Vec3::Zero());
    ++size;
  }
  checkAgainstEigen(assembleSymmetric(size, triplets), coordinates, 1e-10, 1e-3);
  for (int i = 0; i < size; ++i) {  // couples one unknown with all others
    triplets.push_back({size, i, -0.5});
    triplets.push_back({i, i, 0.5});
    triplets.push_back({size, size, 0.5});
  }
  triplets.push_back({size, size, 1.0});
  coordinates.push_back(Vec3::Zero());
  checkAgainstEigen(assembleSymmetric(size + 1, triplets), coordinates, 1e-10, 1e-3);
}

TEST_CASE("cholesky: empty and diagonal matrices") {
  const SymmetricMatrix empty = assembleSymmetric(0, {});
  const Cholesky nothing = factorised(empty, {}, Precision::Single);
  CHECK(nothing.stats().factorEntries == 0);
  std::vector<float> none(4 * static_cast<std::size_t>(nothing.paddedSize()) + 4);
  nothing.solve(none.data());

  std::vector<Triplet> triplets;
  for (int i = 0; i < 1000; ++i) triplets.push_back({i, i, i + 1.0});
  checkAgainstEigen(assembleSymmetric(1000, triplets), {}, 1e-14, 1e-6);
}

TEST_CASE("cholesky: slivers") {
  Random random(7);
  PlainMesh mesh = irregularSheet(40, 40, random);
  // Moves every other row of vertices to within 1e-7 of the previous row: angles of 1e-7 and cotangents of 1e7.
  for (int y = 1; y < 40; y += 2)
    for (int x = 0; x < 40; ++x) mesh.positions[40 * y + x] = mesh.positions[40 * (y - 1) + x] + Vec3(0.3, 1e-7, 0.0);
  shuffleVertices(mesh, random);
  const SymmetricMatrix matrix = pinnedLaplacian(mesh);
  Eigen::MatrixX3d positions(matrix.size, 3);
  for (int v = 0; v < matrix.size; ++v) positions.row(v) = mesh.positions[v];
  const Eigen::MatrixX3d b = lowerTriangle(matrix).selfadjointView<Eigen::Lower>() * positions;
  const Cholesky full = factorised(matrix, mesh.positions, Precision::Double);
  const Cholesky single = factorised(matrix, mesh.positions, Precision::Single);
  const double eigenError = relativeError(eigenSolution(matrix, b), positions);
  const double fullError = relativeError(solve<double>(full, b), positions);
  const double singleError = relativeError(solve<float>(single, b), positions);
  MESSAGE("sliver sheet, error relative to the extent: Eigen " << eigenError << ", double " << fullError << ", single "
                                                               << singleError);
  CHECK(full.stats().regularisedPivots == 0);
  CHECK(fullError < 10.0 * eigenError + 1e-12);
}

TEST_CASE("cholesky: the chunks of a factorisation do not change a bit") {
  Random random(8);
  PlainMesh mesh = bumpySphere(16, random);
  shuffleVertices(mesh, random);
  const SymmetricMatrix matrix = pinnedLaplacian(mesh);
  const std::vector<double> whole = fullSolveBits(matrix, much);
  for (std::int64_t chunk : {1, 1000, 100000}) {
    const std::vector<double> pieces = fullSolveBits(matrix, chunk);
    REQUIRE(pieces.size() == whole.size());
    CHECK(std::memcmp(pieces.data(), whole.data(), whole.size() * sizeof(double)) == 0);
  }
}

TEST_CASE("cholesky: a floating component is regularised and reported, with correct differences") {
  Random random(9);
  PlainMesh mesh = bumpySphere(12, random);
  const int n = static_cast<int>(mesh.positions.size());
  const SymmetricMatrix matrix = assembleSymmetric(n, cotangentTriplets(mesh));
  Eigen::MatrixX3d positions(n, 3);
  for (int v = 0; v < n; ++v) positions.row(v) = mesh.positions[v];
  const Eigen::MatrixX3d b = lowerTriangle(matrix).selfadjointView<Eigen::Lower>() * positions;
  const Cholesky cholesky = factorised(matrix, mesh.positions, Precision::Double);
  CHECK(cholesky.stats().regularisedPivots == 1);
  Eigen::MatrixX3d x = solve<double>(cholesky, b);
  x.rowwise() += (positions.colwise().mean() - x.colwise().mean()).eval();
  CHECK(relativeError(x, positions) < 1e-11);

  const SymmetricMatrix zero = assembleSymmetric(3, {});
  CHECK(factorised(zero, {}, Precision::Single).stats().regularisedPivots == 3);
  // The reciprocal of the smallest numbers overflows.
  const SymmetricMatrix tiny =
      assembleSymmetric(3, std::vector<Triplet>{{0, 0, 1e-310}, {1, 1, 1e-310}, {2, 2, 1}, {1, 0, -1e-310}});
  const Cholesky pinned = factorised(tiny, {}, Precision::Double);
  CHECK(pinned.stats().regularisedPivots == 2);
  CHECK(solve<double>(pinned, Eigen::MatrixX3d::Ones(3, 3)).allFinite());
}

TEST_CASE("cholesky: an indefinite matrix is an error that names the unknown") {
  for (int culprit : {0, 17, 99}) {
    std::vector<Triplet> triplets;
    for (int i = 0; i < 100; ++i) triplets.push_back({i, i, i == culprit ? -1.0 : 2.0});
    const SymmetricMatrix matrix = assembleSymmetric(100, triplets);
    Cholesky cholesky;
    REQUIRE(cholesky.analyse(matrix, {}, Precision::Single).ok());
    const Status status = cholesky.factorise(matrix);
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().code == ErrorCode::NotPositiveDefinite);
    CHECK(status.error().row == culprit);
    CHECK(status.error().vertex == -1);  // an unknown is not an input vertex
  }
  // Indefinite, although every diagonal entry is positive.
  Random random(10);
  const PlainMesh mesh = irregularSheet(30, 30, random);
  std::vector<Triplet> triplets = cotangentTriplets(mesh);
  for (int i = 0; i < 900; ++i) triplets.push_back({i, i, -0.01});
  const SymmetricMatrix matrix = assembleSymmetric(900, triplets);
  Cholesky cholesky;
  REQUIRE(cholesky.analyse(matrix, mesh.positions, Precision::Double).ok());
  const Status status = cholesky.factorise(matrix);
  REQUIRE_FALSE(status.ok());
  CHECK(status.error().code == ErrorCode::NotPositiveDefinite);
}

TEST_CASE("cholesky: malformed input is refused") {
  Random random(11);
  const SymmetricMatrix good = randomDefinite(50, 3, random);
  Cholesky cholesky;
  CHECK_FALSE(cholesky.factoriseStatus().ok());

  SymmetricMatrix notFinite = good;
  notFinite.value[7] = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_FALSE(cholesky.analyse(notFinite, {}, Precision::Single).ok());
  CHECK(cholesky.analyse(notFinite, {}, Precision::Single).error().code == ErrorCode::NotFinite);
  SymmetricMatrix upper = good;
  upper.row[upper.columnStart[20]] = 3;
  CHECK_FALSE(cholesky.analyse(upper, {}, Precision::Single).ok());
  SymmetricMatrix outside = good;
  outside.row.back() = 50;
  CHECK_FALSE(cholesky.analyse(outside, {}, Precision::Single).ok());
  SymmetricMatrix cut = good;
  cut.value.pop_back();
  CHECK_FALSE(cholesky.analyse(cut, {}, Precision::Single).ok());
  SymmetricMatrix backwards = good;
  backwards.columnStart[10] = 1 << 30;
  CHECK_FALSE(cholesky.analyse(backwards, {}, Precision::Single).ok());
  const std::vector<Vec3> tooFew(49);
  CHECK_FALSE(cholesky.analyse(good, tooFew, Precision::Single).ok());
  std::vector<Vec3> infinite(50, Vec3::Zero());
  infinite[13].y() = std::numeric_limits<double>::infinity();
  REQUIRE_FALSE(cholesky.analyse(good, infinite, Precision::Single).ok());
  CHECK(cholesky.analyse(good, infinite, Precision::Single).error().row == 13);

  REQUIRE(cholesky.analyse(good, {}, Precision::Single).ok());
  CHECK_FALSE(cholesky.factorise(randomDefinite(50, 3, random)).ok());
  CHECK_FALSE(cholesky.factorise(notFinite).ok());
  CHECK(cholesky.factorise(good).ok());
}

TEST_CASE("cholesky: factoring again with other values uses them") {
  Random random(12);
  const PlainMesh mesh = irregularSheet(15, 15, random);
  SymmetricMatrix matrix = pinnedLaplacian(mesh);
  Cholesky cholesky = factorised(matrix, mesh.positions, Precision::Double);
  const Eigen::MatrixX3d b = randomRightHandSide(matrix.size, random);
  const Eigen::MatrixX3d before = solve<double>(cholesky, b);
  for (double& value : matrix.value) value *= 4.0;
  REQUIRE(cholesky.factorise(matrix).ok());
  CHECK((4.0 * solve<double>(cholesky, b) - before).cwiseAbs().maxCoeff() == 0.0);
}

}  // namespace shapespline::test::cholesky_test
