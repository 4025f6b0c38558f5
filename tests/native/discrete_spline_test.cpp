// Compares the sampled minimisation of the bending energy with the spline, its limit.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include <Eigen/Dense>

#include "core/sequence/sequence.h"
#include "core/spline/discrete_spline.h"
#include "shapes.h"

namespace shapespline::test::discrete_spline_test {
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

const std::vector<double> evenly = {0, 1, 2, 3, 4}, unevenly = {-1, 0.2, 0.75, 2, 2.6, 4};

Curve curveOf(const CurveOptions& options, const std::vector<double>& times) {
  auto curve = Curve::fit(times, options);
  REQUIRE(curve.ok());
  return std::move(*curve);
}

DiscreteSpline fit(const CurveOptions& options, const std::vector<double>& times, int samples) {
  auto spline = DiscreteSpline::fit(times, options.boundary, curveOf(options, times), samples);
  REQUIRE_MESSAGE(spline.ok(), (spline ? "" : spline.error().message));
  return std::move(*spline);
}

MatrixXd sampled(const Curve& curve, const std::vector<double>& times) {
  MatrixXd rows(static_cast<Eigen::Index>(times.size()), curve.weights(curve.start()).size());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = curve.weights(times[static_cast<std::size_t>(i)]).transpose();
  return rows;
}

double error(const CurveOptions& options, const std::vector<double>& times, int samples) {
  const DiscreteSpline spline = fit(options, times, samples);
  return (spline.weights() - sampled(curveOf(options, times), spline.times())).cwiseAbs().maxCoeff();
}

MatrixXd noise(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

const std::vector<CurveOptions> boundaries = {
    {.boundary = BoundaryKind::Natural},
    {.boundary = BoundaryKind::Hermite, .startSpeed = 0, .endSpeed = 2},
    {.boundary = BoundaryKind::Hermite, .startShape = true, .endShape = true},
    {.boundary = BoundaryKind::Periodic},
    {.boundary = BoundaryKind::Periodic, .closing = Closing::LastKey},
};

// Number of samples for a number of intervals. A periodic path has equally many.
int samplesFor(const CurveOptions& options, int intervals) {
  return options.boundary == BoundaryKind::Periodic ? intervals : intervals + 1;
}

}  // namespace

TEST_CASE("discrete spline: with keys at samples, it converges to the spline with second order") {
  for (const CurveOptions& options : boundaries) {
    double before = 0;
    for (const int n : {40, 80, 160, 320}) {  // four intervals, or five in a closed curve
      const double e = error(options, evenly, samplesFor(options, n));
      const double order = std::log2(before / e);
      MESSAGE(n << " intervals: " << e << (before > 0 ? ", order " + std::to_string(order) : ""));
      if (before > 0) CHECK(order > 1.95);
      before = e;
    }
    CHECK(before < 2e-4);
  }
}

TEST_CASE("discrete spline: also with keys between samples") {
  for (const CurveOptions& options : boundaries) {
    // The error depends on the positions of keys between samples, so the worst of a few sample counts is used.
    const auto worst = [&](int n) {
      double e = 0;
      for (const int more : {0, 1, 3, 7}) e = std::max(e, error(options, unevenly, n + more));
      return e;
    };
    const double coarse = worst(75), fine = worst(300);
    MESSAGE(coarse << " at 75 samples, " << fine << " at 300: order " << std::log2(coarse / fine) / 2);
    CHECK(std::log2(coarse / fine) / 2 > 1.8);
    CHECK(fine < 2e-3);
  }
}

TEST_CASE("discrete spline: its energy is the least of all paths through the keys") {
  for (const CurveOptions& options : boundaries)
    for (const auto& times : {evenly, unevenly}) {
      const DiscreteSpline spline = fit(options, times, samplesFor(options, 120));
      const MatrixXd& path = spline.weights();
      const MatrixXd gram = MatrixXd::Identity(path.cols(), path.cols());
      const double least = spline.energy(path, gram);
      // Changes that keep the keys: random changes projected off the span of the keys' rows.
      const MatrixXd c = spline.holds();
      const auto held = [&](const MatrixXd& change) -> MatrixXd {
        return change - c.transpose() * (c * c.transpose()).ldlt().solve(c * change);
      };
      const MatrixXd bend = spline.gradient(path),
                     anywhere = spline.gradient(path + 0.01 * held(noise(path.rows(), path.cols())));
      CHECK(held(bend).norm() < 1e-9 * anywhere.norm());
      for (const double size : {1e-3, 0.1, 1.0}) {
        CHECK(spline.energy(path + size * held(noise(path.rows(), path.cols())), gram) > least);
        VectorXd wave(path.rows());
        for (Eigen::Index i = 0; i < wave.size(); ++i) wave[i] = std::sin(2 * pi * 3 * double(i) / double(wave.size()));
        CHECK(spline.energy(path + size * held(wave) * noise(1, path.cols()), gram) > least);
      }
      if (times != evenly) continue;  // for other times, the spline does not hold the keys by linear interpolation
      const double ofSpline = spline.energy(sampled(curveOf(options, times), spline.times()), gram);
      CHECK(ofSpline >= least);
      CHECK(ofSpline < 1.01 * least);
    }
}

TEST_CASE("discrete spline: the energy is the integral of the second derivative's square") {
  for (const CurveOptions& options : boundaries) {
    const Curve curve = curveOf(options, evenly);
    const DiscreteSpline spline = fit(options, evenly, samplesFor(options, 400));
    VectorXd y = noise(curve.weights(0).size(), 1);
    double integral = 0;
    const int steps = 40000;
    for (int i = 0; i < steps; ++i) {
      const double t = curve.start() + (curve.end() - curve.start()) * (i + 0.5) / steps;
      integral += std::pow(curve.weights(t, 2).dot(y), 2) * (curve.end() - curve.start()) / steps;
    }
    CHECK(spline.energy(spline.weights(), y * y.transpose()) == doctest::Approx(integral).epsilon(1e-3));
  }
}

TEST_CASE("discrete spline: invalid numbers of samples are refused") {
  const Curve curve = curveOf({}, unevenly);
  for (const int samples : {-1, 0, 3, 10, 1001})
    CHECK(DiscreteSpline::fit(unevenly, BoundaryKind::Natural, curve, samples).error().code ==
          ErrorCode::InvalidOption);
  // the shortest interval is 0.55 of a total of 5
  CHECK(DiscreteSpline::fit(unevenly, BoundaryKind::Natural, curve, 11).ok());
}

TEST_CASE("discrete spline: two keys give a straight line with zero energy") {
  const DiscreteSpline spline = fit({}, {0, 2}, 9);
  CHECK(spline.energy(spline.weights(), MatrixXd::Identity(4, 4)) < 1e-20);
  CHECK(spline.weights()(2, 0) == doctest::Approx(0.75));
  const DiscreteSpline closed = fit({.boundary = BoundaryKind::Periodic, .closing = Closing::LastKey}, {0, 2}, 8);
  CHECK(closed.energy(closed.weights(), MatrixXd::Identity(4, 4)) < 1e-20);
}

TEST_CASE("discrete path: the feature vector of a sequence converges to the spline in its metric") {
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    MotionOptions motion;
    motion.boundary = boundary;
    auto s =
        Sequence::create(keyframes(box(1, 1, 6, 2, 2, 12), {bend(0), bend(1), twist(1)}), doublePrecision(), motion);
    REQUIRE(s.ok());
    CHECK(s->featureCurve()->plane({}).explained ==
          doctest::Approx(1));  // for three keys, the plane contains the whole metric
    const auto distance = [&](int intervals) {
      const int samples = boundary == BoundaryKind::Periodic ? intervals : intervals + 1;
      const auto path = s->featureCurve()->discretePath(samples);
      REQUIRE(path.ok());
      CHECK(path->energy > 0);
      CHECK(path->curveEnergy >= path->energy);  // every key is a sample here
      CHECK(path->curveEnergy < 1.1 * path->energy);
      REQUIRE(path->weights.size() == 3 * std::size_t(samples));
      const ShapePlane plane = s->featureCurve()->plane(path->times);
      REQUIRE(plane.curve.size() == path->plane.size());
      double largest = 0;
      for (std::size_t i = 0; i < plane.curve.size(); ++i)
        largest = std::max(largest, std::abs(plane.curve[i] - path->plane[i]));
      return largest;
    };
    const double coarse = distance(60), fine = distance(240);
    MESSAGE("in the metric: " << coarse << " at 60 samples, " << fine << " at 240");
    CHECK(fine < coarse / 14);  // second order would give 16
    CHECK(s->featureCurve()->discretePath(2).error().code == ErrorCode::InvalidOption);
  }
}

}  // namespace shapespline::test::discrete_spline_test
