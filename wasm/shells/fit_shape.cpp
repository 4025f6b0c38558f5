#include "shells/fit_shape.h"

#include <cmath>

namespace shapespline {

namespace {

constexpr int maxFitSteps = 200;
constexpr double firstDamping = 1e-3, maxDamping = 1e6;
constexpr double fitStop = 1e-6;  // stops at steps shorter than this share of the shape's size

}  // namespace

std::optional<Positions> fitShape(ShellSystem& system, const ShellMeasures& target, Positions shape, double size,
                                  const ShapeTest& isAllowed) {
  const ShellMetric& metric = system.metric();
  ShellMeasures error = metric.difference(metric.measuresOf(shape), target);
  double energy = metric.squaredNorm(error);
  double damping = firstDamping;
  for (int step = 0; step < maxFitSteps && std::isfinite(energy); ++step) {
    const Positions force = system.transposed(shape, error);
    system.fill(shape);
    for (bool better = false; !better; damping *= better ? 0.1 : 10) {
      if (damping > maxDamping || !system.factor(damping)) return std::nullopt;
      const Positions change = system.solve(force);
      const double length = largestNorm(change);
      if (length <= fitStop * size) return shape;
      Positions trial = shape;
      addScaled(trial, -1, change);
      ShellMeasures trialError = metric.difference(metric.measuresOf(trial), target);
      const double trialEnergy = metric.squaredNorm(trialError);
      better = trialEnergy < energy && isAllowed(trial);
      if (better) {
        shape = std::move(trial);
        error = std::move(trialError);
        energy = trialEnergy;
      }
    }
  }
  return std::nullopt;
}

}  // namespace shapespline
