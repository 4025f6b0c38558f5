// The vector kernels against a build of the same code in plain C++. Every operation of simd.h rounds once in both, so
// that the tolerance is none: the same bits.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scalar_kernels.h"

namespace {

using kernels::Surface;

// A bumpy sheet with a few faces more than a whole number of blocks.
Surface sheet() {
  Surface surface;
  kernels::Noise noise;
  constexpr int size = 12;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      surface.xyz.insert(surface.xyz.end(), {x + 0.2 * noise.next(), y + 0.2 * noise.next(), 0.5 * noise.next()});
  for (int y = 0; y + 1 < size; ++y)
    for (int x = 0; x + 1 < size; ++x) {
      const int a = y * size + x;
      surface.faces.push_back({a, a + 1, a + size});
      if (x + y > 0) surface.faces.push_back({a + 1, a + size + 1, a + size});
    }
  return surface;
}

template <class Real>
void checkRightHandSides() {
  for (const bool logarithmic : {false, true})
    for (const double largestTurn : {0.1, 1.0, 3.0, 12.0}) {  // few terms, all, at the end of the series, beyond it
      CAPTURE(largestTurn);
      const auto vector = shapespline::kernelRuns::rightHandSide<Real>(sheet(), largestTurn, logarithmic);
      CHECK(vector == kernels::scalarRightHandSide(sheet(), Real(), largestTurn, logarithmic));
    }
}

// From the key at rest on and from a stored one, a little way and far.
template <class Real>
void checkRightHandSidesBeyondKeys() {
  for (const bool logarithmic : {false, true})
    for (const kernels::Blend& blend :
         {kernels::Blend{{1.1, -0.3, 0.2}, 0}, {{11, -13, 3}, 0}, {{0.2, -0.3, 1.1}, 2}, {{-9, 4, 6}, 2}}) {
      CAPTURE(blend.weights[0]);
      const auto vector = shapespline::kernelRuns::rightHandSide<Real>(sheet(), 1.0, logarithmic, blend);
      CHECK(vector == kernels::scalarRightHandSide(sheet(), Real(), 1.0, logarithmic, blend));
      CHECK(vector.back() == 0);  // no face is lost
      CHECK(std::all_of(vector.begin(), vector.end(), [](Real x) { return std::isfinite(x); }));
      const auto unlimited =
          shapespline::kernelRuns::rightHandSide<Real>(sheet(), 1.0, logarithmic, {blend.weights, -1});
      CHECK(vector != unlimited);
    }
}

template <class Real>
void checkSolutions() {
  for (const int size : {1, 2, 3, 4, 5, 8, 63, 64, 65, 150}) {
    CAPTURE(size);
    CHECK(shapespline::kernelRuns::denseSolution<Real>(size) == kernels::scalarSolution(size, Real()));
  }
}

}  // namespace

TEST_CASE("kernels: right-hand sides are those of the scalar build, bit for bit") {
  checkRightHandSides<float>();
  checkRightHandSides<double>();
}

TEST_CASE("kernels: right-hand sides beyond the keys are those of the scalar build, bit for bit") {
  checkRightHandSidesBeyondKeys<float>();
  checkRightHandSidesBeyondKeys<double>();
}

TEST_CASE("kernels: float right-hand sides stay within 1e-6 of the double ones") {
  // Small and large turns take series of different lengths: both must be good.
  for (const double largestTurn : {0.1, 0.28, 1.0, 3.0}) {
    const auto single = shapespline::kernelRuns::rightHandSide<float>(sheet(), largestTurn, false);
    const auto full = shapespline::kernelRuns::rightHandSide<double>(sheet(), largestTurn, false);
    double largest = 0, extent = 0;
    for (std::size_t i = 0; i + 1 < full.size(); ++i) {
      largest = std::max(largest, std::abs(single[i] - full[i]));
      extent = std::max(extent, std::abs(full[i]));
    }
    CHECK(largest < 1e-6 * extent);
  }
}

TEST_CASE("kernels: solutions are those of the scalar build, bit for bit") {
  checkSolutions<float>();
  checkSolutions<double>();
}

TEST_CASE("kernels: update matrices are those of the scalar build, bit for bit") {
  for (const int pivots : {1, 4, 6, 33})
    for (const int rows : {1, 4, 7, 50}) {
      CAPTURE(pivots);
      CAPTURE(rows);
      CHECK(shapespline::kernelRuns::denseUpdate(pivots, rows) == kernels::scalarUpdate(pivots, rows));
    }
}

TEST_CASE("kernels: normals are those of the scalar build, bit for bit, and unit vectors") {
  const std::vector<float> normals = shapespline::kernelRuns::vertexNormals(sheet());
  CHECK(normals == kernels::scalarNormals(sheet()));
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const double length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    CHECK(length == doctest::Approx(1).epsilon(1e-6));
  }
  Surface tiny = sheet();
  for (double& x : tiny.xyz) x *= 1e-15;  // squares of areas leave the range of float
  const std::vector<float> same = shapespline::kernelRuns::vertexNormals(tiny);
  for (std::size_t i = 0; i < normals.size(); ++i) CHECK(same[i] == doctest::Approx(normals[i]).epsilon(1e-4));
  Surface flat = sheet();
  for (double& x : flat.xyz) x = 1;
  const std::vector<float> up = shapespline::kernelRuns::vertexNormals(flat);
  for (std::size_t i = 0; i < up.size(); ++i) CHECK(up[i] == (i % 3 == 2 ? 1.0f : 0.0f));
}

TEST_CASE("kernels: a column in which every face rests is not stored, and one in which a face does not, is") {
  using shapespline::FaceCoordinates;
  FaceCoordinates<float> coordinates(6, 3, 1.0f);
  coordinates.store();
  for (int f = 0; f < 6; ++f) coordinates.set(f, 1, 0, 0.1f * static_cast<float>(f)), coordinates.set(f, 2, 3, 2.0f);
  coordinates.dropIfAtRest(1);
  CHECK(coordinates.weights({.column = {0.25, 0.5, 0.25}}).stored.size() == 3);
  coordinates.dropIfAtRest(0);
  const auto weights = coordinates.weights({.column = {0.25, 0.5, 0.25}});
  REQUIRE(weights.stored.size() == 2);
  CHECK(weights.stored[0].weight == 0.5f);
  CHECK(weights.stored[1].weight == 0.25f);
  CHECK(weights.atRest == 0.25f);
  coordinates.reorder({5, 3, 1, 0, 2, 4});
  for (int f = 0; f < 6; ++f) {
    CHECK(coordinates.at(f, 0, 0) == 0.0f);
    CHECK(coordinates.at(f, 0, 5) == 1.0f);
    CHECK(coordinates.at(f, 1, 0) == 0.1f * static_cast<float>(f));
    CHECK(coordinates.at(f, 2, 3) == 2.0f);
  }
}

TEST_CASE("kernels: columns whose weight the precision cannot see are left out, and the others keep their places") {
  using shapespline::FaceCoordinates;
  const shapespline::PoseWeights weights{.column = {1e-3, 1e-9, -1e-10, 0.5, 1e-19, 0.499}, .keys = 6};
  FaceCoordinates<float> single(4, 6, 1.0f);
  FaceCoordinates<double> full(4, 6, 1.0);
  single.store(), full.store();
  const auto placesOf = [](const auto& list) {
    std::vector<int> places;
    for (const auto& column : list.stored) places.push_back(column.place);
    return places;
  };
  CHECK(placesOf(single.weights(weights)) == std::vector<int>{0, 3, 5});
  CHECK(placesOf(full.weights(weights)) == std::vector<int>{0, 1, 2, 3, 5});
}

TEST_CASE("kernels: a blend of many columns with the weights of a spline is that of all of them, to a rounding step") {
  // Away from t the weights fall by 0.27 a key.
  std::vector<double> weights(100);
  double sum = 0;
  for (int c = 0; c < 100; ++c) sum += weights[c] = std::pow(-0.27, std::abs(c - 40));
  for (double& w : weights) w /= sum;
  shapespline::FaceCoordinates<float> coordinates(1, 100, 1.0f);
  coordinates.store();
  const auto list = coordinates.weights({.column = weights, .keys = 100});
  CHECK(list.stored.size() < 40);
  CHECK(list.stored.size() > 20);
  double left = 0;
  for (const double w : weights) left += std::abs(w);
  for (const auto& column : list.stored) left -= std::abs(weights[column.place]);
  CHECK(10 * left < 6e-8);  // numbers of ten: half a step of a sum of one
}
