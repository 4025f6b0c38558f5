#include "core/spline/slope_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shapespline {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Farthest knots with a weight in the slope at a knot. From knot to knot, weights fall at least to half, so a farther
// one is less than 1e-38 of the nearest. Shorter curves have all weights.
constexpr Index farthestKnot = 128;

double quotientOf(const VectorXd& times, Index interval) { return 1 / (times[interval + 1] - times[interval]); }

// Difference quotients: 1 / h per interval between knots.
VectorXd quotientsOf(const VectorXd& times) {
  VectorXd quotient(times.size() - 1);
  for (Index i = 0; i < quotient.size(); ++i) quotient[i] = quotientOf(times, i);
  return quotient;
}

// Adds `factor` times the difference quotient of an interval to the slope at a knot.
void addSecant(SlopeRows& slope, Index knot, Index interval, double factor, double quotient) {
  slope(knot, interval) += factor * -quotient;
  slope(knot, interval + 1) += factor * quotient;
}

// A tridiagonal system for the slopes. Row i: lower s_(i-1) + diagonal s_i + upper s_(i+1) = right-hand side.
struct SlopeSystem {
  VectorXd lower, diagonal, upper;
  SlopeRows rhs;

  explicit SlopeSystem(Index n)
      : lower(VectorXd::Zero(n)), diagonal(VectorXd::Zero(n)), upper(VectorXd::Zero(n)), rhs(n) {}

  // Thomas algorithm. The systems are diagonally dominant, so they need no pivoting.
  SlopeRows solve() && {
    const Index n = diagonal.size(), last = n - 1;
    for (Index i = 1; i < n; ++i) {
      const double factor = lower[i] / diagonal[i - 1];
      diagonal[i] -= factor * upper[i - 1];
      rhs.subtract(i, factor, i - 1);
    }
    for (double& w : rhs.row(last)) w /= diagonal[last];
    for (Index i = last - 1; i >= 0; --i) {
      rhs.subtract(i, upper[i], i + 1);
      for (double& w : rhs.row(i)) w /= diagonal[i];
    }
    return std::move(rhs);
  }
};

// Slopes of the C2 spline: continuous second derivative at inner knots, a boundary condition at either end.
SlopeSystem openSystem(const VectorXd& quotient, const CurveOptions& options) {
  const Index n = quotient.size() + 1, last = n - 1;
  SlopeSystem system(n);
  auto& [lower, diagonal, upper, rhs] = system;
  for (Index i = 1; i < last; ++i) {
    const double before = lower[i] = quotient[i - 1], after = upper[i] = quotient[i];
    diagonal[i] = 2 * (before + after);
    rhs(i, i - 1) = 3 * (-before * before);
    rhs(i, i) = 3 * (before * before - after * after);
    rhs(i, i + 1) = 3 * (after * after);
  }
  if (options.boundary == BoundaryKind::Hermite) {
    diagonal[0] = diagonal[last] = 1;
    const double start = options.startSpeed * quotient[0], end = options.endSpeed * quotient[last - 1];
    rhs(0, 0) = -start;
    rhs(last, last) = end;
    (options.startShape ? rhs.startTangent(0) : rhs(0, 1)) = start;
    (options.endShape ? rhs.endTangent(last) : rhs(last, last - 1)) = -end;
  } else {  // natural: zero second derivative
    diagonal[0] = diagonal[last] = 2;
    upper[0] = lower[last] = 1;
    addSecant(rhs, 0, 0, 3, quotient[0]);
    addSecant(rhs, last, last - 1, 3, quotient[last - 1]);
  }
  return system;
}

// The cubic Hermite basis of an interval: factors of the values and slopes at its ends.
struct HermiteBasis {
  double v0, v1, s0, s1;
};

HermiteBasis hermiteBasis(double u, double h, int derivative) {
  if (derivative == 0) {
    const double w = 1 - u;
    return {w * w * (1 + 2 * u), u * u * (3 - 2 * u), h * u * w * w, -h * u * u * w};
  }
  if (derivative == 1) {
    const double v1 = 6 * u * (1 - u) / h;
    return {-v1, v1, (1 - u) * (1 - 3 * u), u * (3 * u - 2)};
  }
  const double v1 = (6 - 12 * u) / (h * h);
  return {-v1, v1, (6 * u - 4) / h, (6 * u - 2) / h};
}

}  // namespace

SlopeRows::SlopeRows(Index knots)
    : knots_(knots), width_(std::min(knots, 2 * farthestKnot + 1)), rows_(knots * (width_ + 2)) {}

Index SlopeRows::first(Index i) const { return std::clamp<Index>(i - farthestKnot, 0, knots_ - width_); }

void SlopeRows::subtract(Index i, double factor, Index j) {
  const Index begin = std::max(first(i), first(j)), end = std::min(first(i), first(j)) + width_;
  for (Index knot = begin; knot < end; ++knot) (*this)(i, knot) -= factor * (*this)(j, knot);
  startTangent(i) -= factor * startTangent(j);
  endTangent(i) -= factor * endTangent(j);
}

void SlopeRows::addTo(Weights& weights, Index i, double factor) const {
  const double* row = &rows_[i * (width_ + 2)];
  for (Index k = 0; k < width_; ++k) weights[first(i) + k] += factor * row[k];
  for (Index k = 0; k < 2; ++k) weights[knots_ + k] += factor * row[width_ + k];
}

KnotSpline KnotSpline::fit(VectorXd times, const CurveOptions& options) {
  KnotSpline spline;
  spline.slope_ = openSystem(quotientsOf(times), options).solve();
  spline.times_ = std::move(times);
  return spline;
}

void KnotSpline::shapeSlope(Index knot, double bias, double tension) {
  if (bias != 0) {
    const Index before = std::max<Index>(knot - 1, 0), after = std::min(knot, times_.size() - 2);
    const Index interval = bias > 0 ? before : after;
    for (double& w : slope_.row(knot)) w *= 1 - std::abs(bias);
    addSecant(slope_, knot, interval, std::abs(bias), quotientOf(times_, interval));
  }
  if (tension != 0)
    for (double& w : slope_.row(knot)) w *= 1 - tension;
}

void KnotSpline::scaleSlopes(const VectorXd& tension, const CurveOptions& ends) {
  SlopeSystem system = openSystem(quotientsOf(times_), ends);
  for (Index i = 0; i < tension.size(); ++i) {
    if (tension[i] == 0) continue;
    shapeSlope(i, 0, tension[i]);
    system.lower[i] = system.upper[i] = 0;
    system.diagonal[i] = 1;
    std::ranges::copy(slope_.row(i), system.rhs.row(i).begin());
  }
  slope_ = std::move(system).solve();
}

void KnotSpline::addWeights(double t, int derivative, double factor, Weights& weights) const {
  const Index last = times_.size() - 1, i = intervalAt(times_, t);
  const double h = times_[i + 1] - times_[i], u = (t - times_[i]) / h;
  if (u < 0 || u > 1) {  // f(t) = f(t_e) + f'(t_e) (t - t_e)
    const Index e = u < 0 ? 0 : last;
    if (derivative < 2) slope_.addTo(weights, e, factor * (derivative == 0 ? t - times_[e] : 1));
    if (derivative == 0) weights[e] += factor;
    return;
  }
  const auto [v0, v1, s0, s1] = hermiteBasis(u, h, derivative);
  slope_.addTo(weights, i, factor * s0);
  slope_.addTo(weights, i + 1, factor * s1);
  weights[i] += factor * v0;
  weights[i + 1] += factor * v1;
}

Index intervalAt(const VectorXd& times, double t) {
  const Index upper = std::upper_bound(times.begin(), times.end(), t) - times.begin();
  return std::clamp<Index>(upper - 1, 0, times.size() - 2);
}

}  // namespace shapespline
