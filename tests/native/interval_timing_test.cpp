// Compares timed weights with the formula by dense solves, and checks what timing must not change.
#include <doctest/doctest.h>

#include <random>

#include <Eigen/Dense>

#include "core/spline/spline.h"

namespace shapespline::test::interval_timing_test {

namespace {

const std::vector<double> times = {-1, 0.2, 0.5, 2, 2.3, 4};
const std::vector<double> earlier = {0.3, -0.2, 0.35, -0.35, 0.1, 0.25}, swing = {1, -1, 0.5, -0.7, 1.5, -0.4};

Curve fit(const CurveOptions& options, const std::vector<double>& at = times) {
  auto curve = Curve::fit(at, options);
  REQUIRE_MESSAGE(curve.ok(), (curve ? "" : curve.error().message));
  return std::move(*curve);
}

Eigen::VectorXd randomColumns(int keys) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd y(Columns{keys}.count());
  for (double& x : y) x = uniform(random);
  return y;
}

// beta_k(t) by the coefficients of its cubic pieces: one dense system over all pieces.
double betaByPieces(const std::vector<double>& knots, std::size_t k, double t) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) at.insert(at.end(), {knots[i], (knots[i] + knots[i + 1]) / 2});
  at.push_back(knots.back());
  const auto pieces = static_cast<Eigen::Index>(at.size()) - 1;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(4 * pieces, 4 * pieces);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(4 * pieces);
  Eigen::Index row = 0;
  const auto add = [&](Eigen::Index piece, double x, int derivative, double sign) {
    const double values[3][4] = {{1, x, x * x, x * x * x}, {0, 1, 2 * x, 3 * x * x}, {0, 0, 2, 6 * x}};
    for (int c = 0; c < 4; ++c) a(row, 4 * piece + c) += sign * values[derivative][c];
  };
  const auto isMiddle = [&](Eigen::Index i) { return i == 2 * static_cast<Eigen::Index>(k) + 1; };
  for (Eigen::Index i = 0; i < pieces; ++i) {
    const double h = at[i + 1] - at[i];
    add(i, 0, 0, 1), b[row++] = isMiddle(i);
    add(i, h, 0, 1), b[row++] = isMiddle(i + 1);
    for (int d = 1; d <= 2 && i + 1 < pieces; ++d) add(i, h, d, 1), add(i + 1, 0, d, -1), ++row;
  }
  add(0, 0, 1, 1), ++row;
  add(pieces - 1, at[pieces] - at[pieces - 1], 1, 1);
  const Eigen::VectorXd c = a.fullPivLu().solve(b);
  Eigen::Index i = 0;
  while (i + 1 < pieces && t > at[i + 1]) ++i;
  const double x = t - at[i];
  return c[4 * i] + x * (c[4 * i + 1] + x * (c[4 * i + 2] + x * c[4 * i + 3]));
}

}  // namespace

TEST_CASE("timed weights follow the formula") {
  const Curve plain = fit({}), timed = fit({.timing = {earlier, swing}});
  for (double t = -1; t <= 4; t += 0.0731) {
    Weights expected = plain.weights(t);
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      const double h = times[k + 1] - times[k], middle = times[k] + h / 2, beta = betaByPieces(times, k, t);
      Weights swung = plain.weights(middle);
      swung[static_cast<Eigen::Index>(k)] -= 0.5;
      swung[static_cast<Eigen::Index>(k) + 1] -= 0.5;
      expected += beta * (earlier[k] * h * plain.weights(middle, 1) + swing[k] * swung);
    }
    CHECK((timed.weights(t) - expected).cwiseAbs().maxCoeff() < 1e-10);
  }
}

TEST_CASE("timing keeps the keys and the motion beyond them; 0 changes no bit") {
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    const CurveOptions options{.boundary = boundary, .tension = {0, 0.25, 0, 0, 0.5, 0}};
    CurveOptions zero = options, full = options;
    zero.timing.earlier.assign(6, 0), zero.timing.swing.assign(6, 0);
    full.timing = {earlier, swing};
    const Curve plain = fit(options), none = fit(zero), timed = fit(full);
    for (double t = -2; t <= 6; t += 0.0711) {
      const double inside = plain.wrap(t).time;
      for (int d = 0; d <= 2; ++d) {
        CHECK(none.weights(inside, d) == plain.weights(inside, d));
        CHECK(timed.withoutTiming().weights(inside, d) == plain.weights(inside, d));
        CHECK(timed.weights(inside, d).sum() == doctest::Approx(d == 0 ? 1 : 0).epsilon(1e-9));
        if (inside < plain.start() || inside > plain.end()) CHECK(timed.weights(inside, d) == plain.weights(inside, d));
      }
    }
    for (std::size_t j = 0; j < times.size(); ++j)
      CHECK(timed.weights(times[j])[static_cast<Eigen::Index>(j)] == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("timed weights are C2 between the keys, and in a loop everywhere") {
  const double step = 1e-7;
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Periodic}) {
    const Curve timed = fit({.boundary = boundary, .timing = {earlier, swing}});
    const bool loop = boundary == BoundaryKind::Periodic;
    for (std::size_t j = 0; j < times.size(); ++j) {
      if (!loop && (j == 0 || j + 1 == times.size())) continue;
      for (int d = 0; d <= 2; ++d) {
        const Weights before = timed.weights(timed.wrap(times[j] - step).time, d);
        const Weights after = timed.weights(timed.wrap(times[j] + step).time, d);
        CHECK((before - after).cwiseAbs().maxCoeff() < 1e-3);
      }
    }
  }
}

TEST_CASE("the last value counts in a loop that closes in an additional interval, and only there") {
  const auto last = [](BoundaryKind boundary, Closing closing) {
    const CurveOptions plain{.boundary = boundary, .closing = closing};
    CurveOptions timed = plain;
    timed.timing.earlier = {0, 0, 0, 0, 0, 0.3};
    const double t = boundary == BoundaryKind::Periodic ? fit(plain).end() - 0.4 : 3;
    return (fit(timed).weights(t) - fit(plain).weights(t)).norm();
  };
  CHECK(last(BoundaryKind::Periodic, Closing::Extra) > 0.01);
  CHECK(last(BoundaryKind::Periodic, Closing::LastKey) == 0);
  CHECK(last(BoundaryKind::Natural, Closing::Extra) == 0);
}

TEST_CASE("reversed keys with `earlier` of the other sign give the reversed weights") {
  const Curve timed = fit({.timing = {earlier, swing}});
  std::vector<double> reversed(times.rbegin(), times.rend());
  for (double& t : reversed) t = -t;
  std::vector<double> later(6, 0), swung(6, 0);
  for (int k = 0; k < 5; ++k) later[4 - k] = -earlier[k], swung[4 - k] = swing[k];
  const Curve back = fit({.timing = {later, swung}}, reversed);
  for (double t = -1; t <= 4; t += 0.0713)
    CHECK((timed.weights(t).head(6) - back.weights(-t).head(6).reverse()).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a key with tension 1 stops, whatever the timing of its neighbours; two equal ones do not move") {
  const std::vector<double> tension = {0, 0, 1, 1, 0, 0};
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    const Curve timed = fit({.boundary = boundary, .tension = tension, .timing = {earlier, swing}});
    Eigen::VectorXd y = randomColumns(6);
    y[3] = y[2];
    for (double t = times[2]; t <= times[3]; t += 0.0717)
      CHECK(timed.weights(t).dot(y) == doctest::Approx(y[2]).epsilon(1e-12));
    CHECK(std::abs(timed.weights(times[2], 1).dot(y)) < 1e-12);
    // What timing adds has a continuous acceleration at the keys without tension.
    const Curve plain = timed.withoutTiming();
    const auto added = [&](double t) { return Weights(timed.weights(t, 2) - plain.weights(t, 2)); };
    for (const std::size_t j : {1U, 4U})
      CHECK((added(times[j] - 1e-7) - added(times[j] + 1e-7)).cwiseAbs().maxCoeff() < 1e-2);
  }
}

TEST_CASE("swing -1 is straight at the middle, and earlier moves the middle along") {
  const Curve plain = fit({}), straight = fit({.timing = {{}, std::vector<double>(6, -1)}});
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const Weights middle = straight.weights((times[k] + times[k + 1]) / 2);
    CHECK(middle[static_cast<Eigen::Index>(k)] == doctest::Approx(0.5));
    CHECK(middle[static_cast<Eigen::Index>(k) + 1] == doctest::Approx(0.5));
  }
  const Curve ahead = fit({.timing = {std::vector<double>(6, 0.1), {}}});
  const double middle = (times[2] + times[3]) / 2, h = times[3] - times[2];
  CHECK((ahead.weights(middle) - plain.weights(middle) - 0.1 * h * plain.weights(middle, 1)).norm() < 1e-12);
}

TEST_CASE("a thousand keys keep their weights with timing") {
  std::vector<double> at(1000), a(1000), b(1000);
  for (int j = 0; j < 1000; ++j) at[j] = j + 0.3 * std::sin(j), a[j] = 0.3 * std::cos(j), b[j] = std::sin(3 * j);
  const Curve timed = fit({.timing = {a, b}}, at);
  for (double t = 100.3; t < 110; t += 0.37) {
    CHECK(timed.weights(t).sum() == doctest::Approx(1).epsilon(1e-9));
    CHECK(timed.weights(t).cwiseAbs().sum() < 5);
  }
}

TEST_CASE("timing with a wrong number of values, or one that is not finite, is refused") {
  const auto message = [](const CurveOptions& options) {
    const auto curve = Curve::fit(times, options);
    REQUIRE(!curve.ok());
    CHECK(curve.error().code == ErrorCode::InvalidOption);
    return curve.error().message;
  };
  CHECK(message({.timing = {{1, 2}, {}}}) == "There are 2 values of earlier for 6 keys. Give one per key, or none.");
  CHECK(message({.timing = {{}, {0, 0, NAN, 0, 0, 0}}}) == "A value of swing is not a finite number.");
}

}  // namespace shapespline::test::interval_timing_test
