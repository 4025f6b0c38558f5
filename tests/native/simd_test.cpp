// Compares every lane operation with plain C++, bit for bit. This guarantees equal results in all builds.
#include "core/base/simd.h"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "laplacian_meshes.h"

namespace shapespline::test::simd_test {

namespace {

template <class Vector>
using RealOf = std::conditional_t<std::is_same_v<Vector, Float4>, float, double>;
template <class Vector>
using Numbers = std::array<RealOf<Vector>, sizeof(Vector) / sizeof(RealOf<Vector>)>;

template <class Vector>
Numbers<Vector> numbers(const Vector& v) {
  Numbers<Vector> result;
  v.store(result.data());
  return result;
}

// All NaNs count as equal.
template <class Real>
bool sameBits(Real a, Real b) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

// Numbers of every size and sign, and special values.
template <class Real>
std::vector<Real> samples() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> list = {0,
                            -Real(0),
                            1,
                            -1,
                            Limits::infinity(),
                            -Limits::infinity(),
                            Limits::quiet_NaN(),
                            Limits::min(),
                            -Limits::denorm_min(),
                            Limits::max(),
                            -Limits::max()};
  Random random(1);
  for (int i = 0; i < 61; ++i) list.push_back(static_cast<Real>(random.signedUnit() * std::ldexp(1, i % 20 - 10)));
  return list;
}

// Calls `check` with all pairs of samples, in different lanes.
template <class Vector, class Check>
void forPairs(Check check) {
  const auto list = samples<RealOf<Vector>>();
  Numbers<Vector> a, b;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = 0; j < list.size(); ++j) {
      for (std::size_t k = 0; k < a.size(); ++k)
        a[k] = list[(i + k) % list.size()], b[k] = list[(j + 3 * k) % list.size()];
      check(a, b);
    }
}

template <class Vector, class Operation, class Plain>
bool agrees(Operation operation, Plain plain) {
  bool same = true;
  forPairs<Vector>([&](const Numbers<Vector>& a, const Numbers<Vector>& b) {
    const auto c = numbers(operation(Vector::load(a.data()), Vector::load(b.data())));
    for (std::size_t k = 0; k < c.size(); ++k) same = same && sameBits(c[k], plain(a[k], b[k]));
  });
  return same;
}

}  // namespace

TEST_CASE_TEMPLATE("simd: arithmetic is that of each lane, bit for bit", Vector, Float4, Double2, Double4) {
  using Real = RealOf<Vector>;
  CHECK(agrees<Vector>([](Vector a, Vector b) { return a + b; }, [](Real a, Real b) { return a + b; }));
  CHECK(agrees<Vector>([](Vector a, Vector b) { return a - b; }, [](Real a, Real b) { return a - b; }));
  CHECK(agrees<Vector>([](Vector a, Vector b) { return a * b; }, [](Real a, Real b) { return a * b; }));
  CHECK(agrees<Vector>([](Vector a, Vector b) { return a / b; }, [](Real a, Real b) { return a / b; }));
  CHECK(agrees<Vector>([](Vector a, Vector) { return squareRoot(a); }, [](Real a, Real) { return std::sqrt(a); }));
  CHECK(agrees<Vector>([](Vector a, Vector b) { return smaller(a, b); }, [](Real a, Real b) { return b < a ? b : a; }));
  CHECK(agrees<Vector>([](Vector a, Vector b) { return larger(a, b); }, [](Real a, Real b) { return a < b ? b : a; }));
  if constexpr (std::is_same_v<Vector, Float4>)
    CHECK(agrees<Vector>([](Vector a, Vector) { return magnitude(a); }, [](Real a, Real) { return std::fabs(a); }));
}

TEST_CASE_TEMPLATE("simd: a bit for each lane that is not positive", Vector, Float4, Double2, Double4) {
  bool same = true;
  forPairs<Vector>([&](const Numbers<Vector>& a, const Numbers<Vector>&) {
    int bits = 0;
    for (std::size_t k = 0; k < a.size(); ++k) bits |= (a[k] > 0 ? 0 : 1) << k;
    same = same && notPositive(Vector::load(a.data())) == bits;
  });
  CHECK(same);
}

TEST_CASE_TEMPLATE("simd: splats", Vector, Float4, Double2, Double4) {
  for (const auto x : samples<RealOf<Vector>>())
    for (const auto& all : {numbers(Vector::splat(x)), numbers(Vector::loadSplat(&x))})
      for (const auto y : all) CHECK(sameBits(x, y));
  for (const auto x : numbers(Vector::zero())) CHECK(sameBits(x, RealOf<Vector>(0)));
}

TEST_CASE("simd: lanes are permuted") {
  const float f[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  const Float4 a = Float4::load(f), b = Float4::load(f + 4);
  CHECK(numbers(rotatedXyz(a)) == std::array{2.0f, 3.0f, 1.0f, 4.0f});
  CHECK(numbers(lowHalves(a, b)) == std::array{1.0f, 2.0f, 5.0f, 6.0f});
  CHECK(numbers(highHalves(a, b)) == std::array{3.0f, 4.0f, 7.0f, 8.0f});
  CHECK(numbers(interleaveLow(a, b)) == std::array{1.0f, 5.0f, 2.0f, 6.0f});
  CHECK(numbers(interleaveHigh(a, b)) == std::array{3.0f, 7.0f, 4.0f, 8.0f});
  float three[4] = {9, 9, 9, 9};
  a.storeXyz(three);
  CHECK(std::to_array(three) == std::array{1.0f, 2.0f, 3.0f, 9.0f});
}

TEST_CASE_TEMPLATE("simd: rows become columns", Real, float, double) {
  using Vector = Lanes<Real>;
  Real m[16];
  for (int i = 0; i < 16; ++i) m[i] = static_cast<Real>(i);
  Vector a = Vector::load(m), b = Vector::load(m + 4), c = Vector::load(m + 8), d = Vector::load(m + 12);
  transpose(a, b, c, d);
  CHECK(numbers(a) == std::array<Real, 4>{0, 4, 8, 12});
  CHECK(numbers(b) == std::array<Real, 4>{1, 5, 9, 13});
  CHECK(numbers(c) == std::array<Real, 4>{2, 6, 10, 14});
  CHECK(numbers(d) == std::array<Real, 4>{3, 7, 11, 15});
}

}  // namespace shapespline::test::simd_test
