#include "core/spline/interval_timing.h"

#include <cmath>

namespace shapespline {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Smaller values of beta change no weight.
constexpr double negligibleBeta = 1e-18;

// Knots and middles in turn.
VectorXd withMiddles(const VectorXd& knots) {
  VectorXd times(2 * knots.size() - 1);
  for (Index k = 0; k < knots.size(); ++k) times[2 * k] = knots[k];
  for (Index k = 0; k + 1 < knots.size(); ++k) times[2 * k + 1] = (knots[k] + knots[k + 1]) / 2;
  return times;
}

}  // namespace

IntervalTiming::IntervalTiming(const VectorXd& knots, const VectorXd& tension) {
  const CurveOptions atRest{.boundary = BoundaryKind::Hermite, .startSpeed = 0, .endSpeed = 0};
  beta_ = KnotSpline::fit(withMiddles(knots), atRest);
  if (tension.isZero(0)) return;
  VectorXd ofAll = VectorXd::Zero(beta_.times().size());
  for (Index k = 0; k < knots.size(); ++k) ofAll[2 * k] = tension[k];
  beta_.scaleSlopes(ofAll, atRest);
}

void IntervalTiming::addWeights(const KnotSpline& plain, const Numbers& numbers, double t, int derivative,
                                Weights& weights) const {
  Weights beta = Weights::Zero(beta_.times().size() + 2);
  beta_.addWeights(t, derivative, 1, beta);
  for (Index k = 0; k < numbers.earlier.size(); ++k) {
    const double value = beta[2 * k + 1], middle = beta_.times()[2 * k + 1];
    const double a = value * numbers.earlier[k], b = value * numbers.swing[k];
    if (std::abs(a) > negligibleBeta)
      plain.addWeights(middle, 1, a * (plain.times()[k + 1] - plain.times()[k]), weights);
    if (std::abs(b) <= negligibleBeta) continue;
    plain.addWeights(middle, 0, b, weights);
    weights[k] -= b / 2;
    weights[k + 1] -= b / 2;
  }
}

}  // namespace shapespline
