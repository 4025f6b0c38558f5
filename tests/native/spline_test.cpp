// Compares weights with independent formulas: moments (second derivatives) by a dense solve, instead of slopes by
// elimination.
#include <doctest/doctest.h>

#include <random>

#include <Eigen/Dense>

#include "core/spline/spline.h"

namespace shapespline::test::spline_test {

namespace {

const std::vector<double> times = {-1, 0.2, 0.5, 2, 2.3, 4};

Curve fit(const CurveOptions& options, const std::vector<double>& at = times) {
  auto curve = Curve::fit(at, options);
  REQUIRE_MESSAGE(curve.ok(), (curve ? "" : curve.error().message));
  return std::move(*curve);
}

double value(const Curve& curve, const Eigen::VectorXd& columns, double t, int derivative = 0) {
  return curve.weights(t, derivative).dot(columns);
}

Eigen::VectorXd randomColumns(int keys) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd y(Columns{keys}.count());
  for (double& x : y) x = uniform(random);
  return y;
}

// Natural spline by its moments M: h_i M_i + 2 (h_i + h_(i+1)) M_(i+1) + h_(i+1) M_(i+2) = 6 (d_(i+1) - d_i).
double naturalByMoments(const std::vector<double>& t, const Eigen::VectorXd& y, double at) {
  const int n = static_cast<int>(t.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (int i = 1; i + 1 < n; ++i) {
    const double h0 = t[i] - t[i - 1], h1 = t[i + 1] - t[i];
    a(i, i - 1) = h0, a(i, i) = 2 * (h0 + h1), a(i, i + 1) = h1;
    b[i] = 6 * ((y[i + 1] - y[i]) / h1 - (y[i] - y[i - 1]) / h0);
  }
  const Eigen::VectorXd m = a.fullPivLu().solve(b);
  int i = 0;
  while (i + 2 < n && at > t[i + 1]) ++i;
  const double h = t[i + 1] - t[i], p = t[i + 1] - at, q = at - t[i];
  return m[i] * p * p * p / (6 * h) + m[i + 1] * q * q * q / (6 * h) + (y[i] / h - m[i] * h / 6) * p +
         (y[i + 1] / h - m[i + 1] * h / 6) * q;
}

}  // namespace

TEST_CASE("natural spline equals the one by moments") {
  const Curve curve = fit({});
  const Eigen::VectorXd y = randomColumns(6);
  for (double t = -1; t <= 4; t += 0.07)
    CHECK(value(curve, y, t) == doctest::Approx(naturalByMoments(times, y, t)).epsilon(1e-12));
}

TEST_CASE("a long curve equals the one by moments, open and closed") {
  constexpr int keys = 300;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.01, 1);
  std::vector<double> at = {0};
  while (at.size() < keys) at.push_back(at.back() + step(random));
  const Eigen::VectorXd y = randomColumns(keys);
  const double period = at.back() + 0.5;
  const Curve open = fit({}, at), closed = fit({.boundary = BoundaryKind::Periodic, .period = period}, at);
  // A period between the ends of its neighbours.
  std::vector<double> unrolled;
  Eigen::VectorXd values(keys + 120);
  for (int k = -60; k < keys + 60; ++k) {
    values[k + 60] = y[(k + keys) % keys];
    unrolled.push_back(at[(k + keys) % keys] + (k < 0 ? -period : k >= keys ? period : 0));
  }
  for (const double t : {0.3, 0.5 * period, at.back() - 0.2, period - 0.1}) {
    if (t < at.back()) CHECK(value(open, y, t) == doctest::Approx(naturalByMoments(at, y, t)).epsilon(1e-11));
    CHECK(value(closed, y, t) == doctest::Approx(naturalByMoments(unrolled, values, t)).epsilon(1e-11));
    CHECK(closed.weights(t).sum() == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("weights sum to one, their derivatives to zero") {
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic})
    for (const bool linear : {false, true}) {
      const Curve curve = fit({.linear = linear, .boundary = boundary, .startShape = true, .endShape = true});
      for (double t = -3; t <= 6; t += 0.31) {
        const double inside = curve.wrap(t).time;
        CHECK(curve.weights(inside).sum() == doctest::Approx(1));
        CHECK(std::abs(curve.weights(inside, 1).sum()) < 1e-12);
        CHECK(std::abs(curve.weights(inside, 2).sum()) < 1e-10);
      }
    }
}

TEST_CASE("value, slope and second derivative are continuous across knots") {
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    const Curve curve = fit({.boundary = boundary});
    const Eigen::VectorXd y = randomColumns(6);
    for (std::size_t j = 1; j + 1 < times.size(); ++j)
      for (int d = 0; d <= 2; ++d)
        CHECK(value(curve, y, times[j] - 1e-9, d) ==
              doctest::Approx(value(curve, y, times[j] + 1e-9, d)).epsilon(1e-5));
  }
}

TEST_CASE("natural ends have no second derivative and continue straight") {
  const Curve curve = fit({});
  const Eigen::VectorXd y = randomColumns(6);
  CHECK(std::abs(value(curve, y, -1, 2)) < 1e-10);
  CHECK(std::abs(value(curve, y, 4, 2)) < 1e-10);
  const double slope = value(curve, y, 4, 1);
  CHECK(value(curve, y, 5.5) == doctest::Approx(y[5] + 1.5 * slope));
  CHECK(value(curve, y, -2) == doctest::Approx(y[0] - value(curve, y, -1, 1)));
}

TEST_CASE("hermite ends have the assigned slopes") {
  const Eigen::VectorXd y = randomColumns(6);
  const Curve speeds = fit({.boundary = BoundaryKind::Hermite, .startSpeed = 0, .endSpeed = 2});
  CHECK(std::abs(value(speeds, y, -1, 1)) < 1e-12);
  CHECK(value(speeds, y, 4, 1) == doctest::Approx(2 * (y[5] - y[4]) / 1.7));
  const Curve shapes = fit({.boundary = BoundaryKind::Hermite, .startShape = true, .endShape = true});
  CHECK(value(shapes, y, -1, 1) == doctest::Approx((y[6] - y[0]) / 1.2));
  CHECK(value(shapes, y, 4, 1) == doctest::Approx((y[5] - y[7]) / 1.7));
}

TEST_CASE("a tangent pose equal to the neighbour key changes nothing") {
  Eigen::VectorXd y = randomColumns(6);
  y[6] = y[1], y[7] = y[4];
  const Curve plain = fit({.boundary = BoundaryKind::Hermite}),
              shapes = fit({.boundary = BoundaryKind::Hermite, .startShape = true, .endShape = true});
  for (double t = -2; t <= 5; t += 0.1)
    CHECK(value(plain, y, t) == doctest::Approx(value(shapes, y, t)).epsilon(1e-12));
}

TEST_CASE("a periodic curve closes with equal slope and second derivative") {
  for (const std::size_t keys : {2u, 3u, 4u, 6u}) {
    const std::vector<double> at(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(keys));
    const Curve curve = fit({.boundary = BoundaryKind::Periodic}, at);
    const Eigen::VectorXd y = randomColumns(static_cast<int>(keys));
    const double span = at.back() - at.front();
    CHECK(curve.end() == doctest::Approx(at.back() + span / double(keys - 1)));
    for (int d = 0; d <= 2; ++d)
      CHECK(value(curve, y, curve.start(), d) == doctest::Approx(value(curve, y, curve.end(), d)).epsilon(1e-9));
    const double period = curve.end() - curve.start();
    CHECK(curve.wrap(at[0] + 0.3 + 5 * period).periods == 5);
    CHECK(curve.wrap(at[0] + 0.3 - 2 * period).time == doctest::Approx(at[0] + 0.3));
  }
}

TEST_CASE("a last key that closes the curve ends the period") {
  const Curve curve = fit({.boundary = BoundaryKind::Periodic, .closing = Closing::LastKey});
  CHECK(curve.end() == times.back());
  Eigen::VectorXd y = randomColumns(6);
  y[5] = y[0];
  for (int d = 0; d <= 2; ++d) CHECK(value(curve, y, -1, d) == doctest::Approx(value(curve, y, 4, d)));
}

TEST_CASE("tension scales the slope at a key") {
  const Eigen::VectorXd y = randomColumns(6);
  const Curve plain = fit({}), tense = fit({.tension = {0, 0, 1, 0.25, 0, 0}});
  CHECK(std::abs(value(tense, y, 0.5, 1)) < 1e-12);
  CHECK(value(tense, y, 2, 1) == doctest::Approx(0.75 * value(plain, y, 2, 1)));
  CHECK(value(tense, y, -0.7) == doctest::Approx(value(plain, y, -0.7)));  // the first interval's slopes are unchanged
}

TEST_CASE("a bias of 0 changes no bit; any bias keeps the keys, the affine weights and the continuity of slopes") {
  const std::vector<double> bias = {-0.5, 0.3, 1, -1, 0, 0.8}, tension = {0, 0.25, 0, 0, 0.5, 0};
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    const Curve plain = fit({.boundary = boundary, .tension = tension});
    const Curve none = fit({.boundary = boundary, .tension = tension, .bias = std::vector<double>(6, 0)});
    const Curve biased = fit({.boundary = boundary, .tension = tension, .bias = bias});
    for (double t = plain.start(); t <= plain.end(); t += 0.173)
      for (int d = 0; d <= 2; ++d) {
        CHECK(none.weights(t, d) == plain.weights(t, d));
        CHECK(biased.weights(t, d).sum() == doctest::Approx(d == 0 ? 1 : 0).epsilon(1e-10));
      }
    const Eigen::VectorXd y = randomColumns(6);
    for (std::size_t j = 0; j < times.size(); ++j) CHECK(value(biased, y, times[j]) == y[static_cast<Eigen::Index>(j)]);
    for (std::size_t j = 1; j + 1 < times.size(); ++j)
      CHECK(value(biased, y, times[j] - 1e-9, 1) ==
            doctest::Approx(value(biased, y, times[j] + 1e-9, 1)).epsilon(1e-5));
    if (boundary == BoundaryKind::Periodic)
      CHECK(value(biased, y, biased.start(), 1) == doctest::Approx(value(biased, y, biased.end(), 1)));
  }
}

TEST_CASE("bias moves the slope from that of the C2 spline to the difference before or after the key") {
  const Eigen::VectorXd y = randomColumns(6);
  const Curve plain = fit({}), biased = fit({.bias = {0, 0, 1, -1, 0.25, 1}});
  const auto secant = [&](Eigen::Index i) { return (y[i + 1] - y[i]) / (times[i + 1] - times[i]); };
  CHECK(value(biased, y, 0.5, 1) == doctest::Approx(secant(1)));
  CHECK(value(biased, y, 2, 1) == doctest::Approx(secant(3)));
  CHECK(value(biased, y, 2.3, 1) == doctest::Approx(0.75 * value(plain, y, 2.3, 1) + 0.25 * secant(3)));
  CHECK(value(biased, y, 4, 1) == doctest::Approx(secant(4)));  // an end has one difference only
  CHECK(value(biased, y, -0.7) == doctest::Approx(value(plain, y, -0.7)));
  // At the start of a closed curve, the previous key is the last one, a closing interval earlier.
  const Curve closed = fit({.boundary = BoundaryKind::Periodic, .bias = {1, 0, 0, 0, 0, 0}});
  CHECK(value(closed, y, -1, 1) == doctest::Approx((y[0] - y[5]) / (closed.end() - 4)));
}

TEST_CASE("a curve closed by its last key has one slope there, for any bias and tension of the last key") {
  Eigen::VectorXd y = randomColumns(6);
  y[5] = y[0];
  const Curve curve = fit({.boundary = BoundaryKind::Periodic,
                           .closing = Closing::LastKey,
                           .tension = {0.5, 0, 0, 0, 0, 0},
                           .bias = {0, 0, 0, 0, 0, 1}});
  CHECK(value(curve, y, -1, 1) == doctest::Approx(value(curve, y, 4, 1)));
}

TEST_CASE("piecewise linear weights blend neighbours only") {
  const Curve curve = fit({.linear = true});
  const Weights w = curve.weights(0.35);
  CHECK(w[1] == doctest::Approx(0.5));
  CHECK(w[2] == doctest::Approx(0.5));
  CHECK(curve.weights(5.7)[5] == doctest::Approx(2));
}

TEST_CASE("invalid options are refused with a message") {
  const auto code = [](const CurveOptions& options, const std::vector<double>& at = times) {
    const auto result = Curve::fit(at, options);
    REQUIRE(!result.ok());
    CHECK(result.error().message.size() > 20);
    return result.error().code;
  };
  CHECK(code({.boundary = BoundaryKind::Periodic, .period = 5}) == ErrorCode::InvalidOption);  // the keys span 5
  CHECK(code({.boundary = BoundaryKind::Periodic, .period = 1}) == ErrorCode::InvalidOption);
  const auto nearly = Curve::fit(times, {.boundary = BoundaryKind::Periodic, .period = 5 * (1 + 1e-10)});
  REQUIRE(!nearly.ok());
  CHECK(nearly.error().message.starts_with("The period 5 is longer by less than a billionth than the time"));
  CHECK(code({.startSpeed = NAN}) == ErrorCode::InvalidOption);
  CHECK(code({.tension = {1, 2}}) == ErrorCode::InvalidOption);
  CHECK(code({.bias = {0, 0}}) == ErrorCode::InvalidOption);
  CHECK(code({.bias = {0, 0, 0, 0, 0, 1.5}}) == ErrorCode::InvalidOption);
  CHECK(code({.bias = {0, 0, 0, 0, 0, NAN}}) == ErrorCode::InvalidOption);
  CHECK(code({}, {0, 1, 1}) == ErrorCode::TimesNotIncreasing);
  CHECK(code({}, {0, 2, 1}) == ErrorCode::TimesNotIncreasing);
  for (const double step : {5e-324, 1e-300, 1e-31}) CHECK(code({}, {0, step}) == ErrorCode::TimesNotIncreasing);
  CHECK(Curve::fit({0, 1e-29}, {}).ok());
  CHECK(code({}, {0, 1e10}) == ErrorCode::TooLarge);
  CHECK(code({}, {-1e300, 0}) == ErrorCode::TooLarge);
  CHECK(code({}, {0, INFINITY}) == ErrorCode::NotFinite);
}

}  // namespace shapespline::test::spline_test
