#include "shells/shell_spline.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>

namespace shapespline {

namespace {

constexpr int maxSplineSteps = 40, maxHalvings = 10;
constexpr int maxTrials = 120;       // bounds the time
constexpr double minFall = 1e-4;     // stops when a step lowers the energy by less than this fraction
constexpr double negligible = 1e-6;  // stops at this share of the energy |z'|^2 of the path, with a range of 1
constexpr int maxMeanSteps = 60;
constexpr double meanStop = 1e-8;  // stops at steps shorter than this share of the shape's size
constexpr double slow = 0.3;       // factors again if a step is longer than this share of the previous step
constexpr double lightDamping = 1e-8;
constexpr double preconditionerDamping = 1e-6;
constexpr int maxAdjointSteps = 40;
constexpr double adjointStop = 1e-5;   // stops when the residual has fallen to this fraction
constexpr double probe = 1e-5;         // step of finite differences, as a share of the shape's size
constexpr std::size_t remembered = 8;  // number of pairs that L-BFGS keeps

// Ends of a search without a term that rises most: a step hardly lowers the energy; or a limit was reached, or the
// preconditioner could not be factored.
constexpr int converged = -1, cutShort = -2;

using Path = std::vector<Positions>;

double dotOf(const Path& a, const Path& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

void addScaledPath(Path& to, double factor, const Path& from) {
  for (std::size_t k = 0; k < to.size(); ++k) addScaled(to[k], factor, from[k]);
}

}  // namespace

SpacedTimes::SpacedTimes(const std::vector<double>& times)
    : before(times.size()), after(times.size()), weight(times.size()) {
  const double span = times.back() - times.front();
  for (std::size_t k = 1; k + 1 < times.size(); ++k) {
    const double a = (times[k] - times[k - 1]) / span, b = (times[k + 1] - times[k]) / span;
    before[k] = b / (a + b);
    after[k] = a / (a + b);
    weight[k] = 2 * (a + b) / (a * b * a * b);
  }
}

// Finds the shape whose measures are closest to the mean of its neighbours' measures, by modified Newton steps.
bool ShellSpline::findMean(int k, const std::vector<ShellMeasures>& measures, Positions& mean, ShellMeasures& middle) {
  const ShellMetric& metric = system_->metric();
  middle = measures[k - 1];
  const ShellMeasures step = metric.difference(measures[k + 1], measures[k - 1]);
  for (std::size_t m = 0; m < middle.size(); ++m) middle[m] += spaced_.after[k] * step[m];
  double damping = lightDamping, last = std::numeric_limits<double>::infinity();
  ShellMeasures error = metric.difference(metric.measuresOf(mean), middle);
  double energy = metric.squaredNorm(error);
  bool refresh = true;
  for (int i = 0; i < maxMeanSteps && std::isfinite(energy); ++i) {
    if (refresh) {
      system_->fill(mean);
      if (!system_->factor(damping)) return false;
    }
    const Positions change = system_->solve(system_->transposed(mean, error));
    const double length = largestNorm(change) / size_;
    if (length <= meanStop) return true;
    Positions trial = mean;
    addScaled(trial, -1, change);
    ShellMeasures trialError = metric.difference(metric.measuresOf(trial), middle);
    const double trialEnergy = metric.squaredNorm(trialError);
    // For steps this short, the energy differs only by rounding.
    const bool better = trialEnergy < energy || length < 1e-6;
    refresh = !better || length > slow * last;
    if (better) {
      mean = std::move(trial);
      error = std::move(trialError);
      energy = trialEnergy;
      last = length;
    }
    damping = better ? std::max(damping * 0.1, lightDamping) : damping * 10;
  }
  return false;
}

// Solves H x = J^T W away, where H is the second derivative of half the squared distance that the mean minimises.
// Conjugate gradients, preconditioned by the last factor, which is close to H.
Positions ShellSpline::adjointOf(const Positions& mean, const ShellMeasures& middle, const ShellMeasures& away) {
  const ShellMetric& metric = system_->metric();
  const auto slopeAt = [&](const Positions& direction, double step) {
    Positions moved = mean;
    addScaled(moved, step, direction);
    return system_->transposed(moved, metric.difference(metric.measuresOf(moved), middle));
  };
  const auto times = [&](const Positions& direction) {
    const double step = probe * size_ / std::max(largestNorm(direction), std::numeric_limits<double>::min());
    Positions product = slopeAt(direction, step);
    addScaled(product, -1, slopeAt(direction, -step));
    for (Vec3& v : product) v /= 2 * step;
    return product;
  };
  Positions residual = system_->transposed(mean, away);
  Positions solution(mean.size(), Vec3::Zero()), direction = system_->solve(residual);
  double along = dot(residual, direction);
  const double first = along;
  for (int i = 0; i < maxAdjointSteps && along > adjointStop * adjointStop * first; ++i) {
    const Positions product = times(direction);
    const double curvature = dot(direction, product);
    if (!(curvature > 0)) break;
    addScaled(solution, along / curvature, direction);
    addScaled(residual, -along / curvature, product);
    Positions next = system_->solve(residual);
    const double before = std::exchange(along, dot(residual, next));
    addScaled(next, along / before, direction);
    direction = std::move(next);
  }
  return solution;
}

void ShellSpline::moveToMeans(std::vector<Positions>& shapes, const std::vector<char>& chosen) {
  std::vector<ShellMeasures> measures;
  for (const Positions& shape : shapes) measures.push_back(system_->metric().measuresOf(shape));
  for (int k = 1; k + 1 < static_cast<int>(shapes.size()); ++k) {
    Positions mean = shapes[k];
    ShellMeasures middle;
    if (!chosen[k] || !findMean(k, measures, mean, middle)) continue;
    measures[k] = system_->metric().measuresOf(mean);
    shapes[k] = std::move(mean);
  }
}

double ShellSpline::energy(const std::vector<Positions>& shapes, std::vector<Positions>* gradient) {
  const ShellMetric& metric = system_->metric();
  if (means_.empty()) means_ = shapes;
  std::vector<ShellMeasures> measures;
  for (const Positions& shape : shapes) measures.push_back(metric.measuresOf(shape));
  if (gradient) gradient->assign(shapes.size(), Positions(shapes.front().size(), Vec3::Zero()));
  double sum = 0;
  terms_.assign(shapes.size(), 0);
  for (int k = 1; k + 1 < static_cast<int>(shapes.size()); ++k) {
    if (!omitted_.empty() && omitted_[k]) continue;
    Positions mean = means_[k];
    ShellMeasures middle;
    if (!findMean(k, measures, mean, middle)) {
      terms_[k] = std::numeric_limits<double>::infinity();
      return terms_[k];
    }
    const ShellMeasures away = metric.difference(measures[k], metric.measuresOf(mean));
    terms_[k] = spaced_.weight[k] * metric.squaredNorm(away);
    sum += terms_[k];
    if (gradient) {
      const double twice = 2 * spaced_.weight[k];
      const Positions adjoint = adjointOf(mean, middle, away);
      const ShellMeasures carried = metric.changeOf(mean, adjoint);
      addScaled((*gradient)[k], twice, system_->transposed(shapes[k], away));
      addScaled((*gradient)[k - 1], -twice * spaced_.before[k], system_->transposed(shapes[k - 1], carried));
      addScaled((*gradient)[k + 1], -twice * spaced_.after[k], system_->transposed(shapes[k + 1], carried));
    }
    means_[k] = std::move(mean);
  }
  return sum;
}

namespace {

/// Approximates the inverse of the energy's second derivative. In time, it inverts the second differences; in space, it
/// finds the change of a shape from a change of its measures. Every shape has its own factor, because shapes rotate.
class Preconditioner {
 public:
  static Result<Preconditioner> create(const ShellMetric& metric, const SpacedTimes& spaced, const Path& shapes,
                                       const std::vector<char>& fixed) {
    Preconditioner made(metric, shapes);
    for (std::size_t k = 0; k < fixed.size(); ++k) {
      if (fixed[k]) continue;
      auto system = ShellSystem::create(metric);
      if (!system) return system.error();
      system->fill(shapes[k]);
      if (!system->factor(preconditionerDamping)) return Error{ErrorCode::NotPositiveDefinite, ""};
      made.systems_.push_back(std::move(*system));
      made.free_.push_back(static_cast<int>(k));
    }
    made.invertDifferences(spaced, static_cast<int>(fixed.size()));
    return made;
  }

  Path apply(const Path& gradient) {
    std::vector<ShellMeasures> inMeasures;
    for (std::size_t i = 0; i < free_.size(); ++i)
      inMeasures.push_back(metric_->changeOf(shapes_[free_[i]], systems_[i].solve(gradient[free_[i]])));
    Path result(gradient.size(), Positions(gradient.front().size(), Vec3::Zero()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      ShellMeasures change(inMeasures.front().size(), 0);
      for (std::size_t j = 0; j < free_.size(); ++j)
        for (std::size_t m = 0; m < change.size(); ++m)
          change[m] += inTime_(static_cast<int>(i), static_cast<int>(j)) * inMeasures[j][m];
      result[free_[i]] = systems_[i].solve(systems_[i].transposed(shapes_[free_[i]], change));
    }
    return result;
  }

 private:
  Preconditioner(const ShellMetric& metric, const Path& shapes) : metric_(&metric), shapes_(shapes) {}

  void invertDifferences(const SpacedTimes& spaced, int count) {
    Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(count, count);
    for (int k = 1; k + 1 < count; ++k) {
      const double scale = std::sqrt(2 * spaced.weight[k]);
      differences(k, k - 1) = -scale * spaced.before[k];
      differences(k, k) = scale;
      differences(k, k + 1) = -scale * spaced.after[k];
    }
    const int freeCount = static_cast<int>(free_.size());
    Eigen::MatrixXd kept(count, freeCount);
    for (int i = 0; i < freeCount; ++i) kept.col(i) = differences.col(free_[i]);
    inTime_ = (kept.transpose() * kept).ldlt().solve(Eigen::MatrixXd::Identity(freeCount, freeCount));
  }

  const ShellMetric* metric_;
  Path shapes_;
  std::vector<ShellSystem> systems_;
  std::vector<int> free_;
  Eigen::MatrixXd inTime_;
};

/// The two-loop recursion (Nocedal 1980).
struct Memory {
  struct Pair {
    Path step, change;
    double inverse;
  };
  std::deque<Pair> pairs;

  void add(Path step, Path change) {
    const double product = dotOf(step, change);
    if (!(product > 0)) return;
    pairs.push_back({std::move(step), std::move(change), 1 / product});
    if (pairs.size() > remembered) pairs.pop_front();
  }

  template <class Inverse>
  Path direction(Path gradient, const Inverse& inverse) const {
    std::vector<double> shares;
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
      shares.push_back(pair->inverse * dotOf(pair->step, gradient));
      addScaledPath(gradient, -shares.back(), pair->change);
    }
    Path result = inverse(gradient);
    for (const Pair& pair : pairs) {
      const double back = pair.inverse * dotOf(pair.change, result);
      addScaledPath(result, shares.back() - back, pair.step);
      shares.pop_back();
    }
    return result;
  }
};

void release(Path& gradient, const std::vector<char>& fixed) {
  for (std::size_t k = 0; k < fixed.size(); ++k)
    if (fixed[k]) gradient[k].assign(gradient[k].size(), Vec3::Zero());
}

}  // namespace

std::vector<char> ShellSpline::minimise(std::vector<Positions>& shapes, const std::vector<char>& fixed,
                                        const FractionReport& onProgress) {
  const Path starts = shapes;
  std::vector<char> kept = fixed, unchanged(shapes.size(), 0);
  omitted_.assign(shapes.size(), 0);
  while (std::count(kept.begin(), kept.end(), 0) > 0) {
    const int worst = descend(shapes, kept, onProgress);
    if (worst == cutShort) {
      finished_ = false;
      for (std::size_t k = 0; k < shapes.size(); ++k) unchanged[k] |= !fixed[k] && shapes[k] == starts[k];
    }
    if (worst < 0) break;
    omitted_[worst] = 1;
    for (int k = worst - 1; k <= worst + 1; ++k) {
      unchanged[k] = !fixed[k] && shapes[k] == starts[k];
      kept[k] = 1;
    }
  }
  omitted_.clear();
  return unchanged;
}

// The mean of |z'|^2 over the path, with a range of 1.
double ShellSpline::speedOf(const std::vector<Positions>& shapes) const {
  const ShellMetric& metric = system_->metric();
  double sum = 0;
  for (std::size_t k = 1; k < shapes.size(); ++k)
    sum += metric.squaredNorm(metric.difference(metric.measuresOf(shapes[k]), metric.measuresOf(shapes[k - 1])));
  return sum * static_cast<double>(shapes.size() - 1);
}

// Returns the time of the term that rises most where no step lowers the energy, or why it ended.
int ShellSpline::descend(std::vector<Positions>& shapes, const std::vector<char>& fixed,
                         const FractionReport& onProgress) {
  const auto worstSince = [&](const std::vector<double>& before) {
    int worst = 1;
    for (int k = 1; k + 1 < static_cast<int>(shapes.size()); ++k)
      if (terms_[k] - before[k] > terms_[worst] - before[worst]) worst = k;
    return worst;
  };
  Path gradient;
  double energy = this->energy(shapes, &gradient);
  if (!std::isfinite(energy)) return worstSince(std::vector<double>(shapes.size(), 0));
  auto preconditioner = Preconditioner::create(system_->metric(), spaced_, shapes, fixed);
  if (!preconditioner) return cutShort;
  release(gradient, fixed);
  Memory memory;
  const double least = negligible * this->speedOf(shapes);
  double length = 1;
  for (; steps_ < maxSplineSteps && trials_ < maxTrials; ++steps_) {
    reportFraction(onProgress, std::max(double(steps_) / maxSplineSteps, double(trials_) / maxTrials));
    const Path direction = memory.direction(gradient, [&](const Path& g) { return preconditioner->apply(g); });
    const double slope = dotOf(gradient, direction);
    if (energy <= least || !(slope > minFall * energy)) return converged;
    length = std::min(1.0, 4 * length);
    const Path means = means_;
    const std::vector<double> terms = terms_;
    Path trial;
    bool lower = false;
    for (int halvings = 0; halvings < maxHalvings && !lower; ++halvings, ++trials_) {
      if (halvings > 0) length /= 2;
      trial = shapes;
      addScaledPath(trial, -length, direction);
      means_ = means;
      lower = this->energy(trial) <= energy - 1e-4 * length * slope;
    }
    if (!lower) {
      means_ = means;
      return worstSince(terms);
    }
    Path trialGradient;
    const double trialEnergy = this->energy(trial, &trialGradient);
    release(trialGradient, fixed);
    Path moved = trial, changed = trialGradient;
    addScaledPath(moved, -1, shapes);
    addScaledPath(changed, -1, gradient);
    memory.add(std::move(moved), std::move(changed));
    shapes = std::move(trial);
    gradient = std::move(trialGradient);
    const double fall = energy - trialEnergy;
    energy = trialEnergy;
    if (fall < minFall * energy) return converged;
  }
  return cutShort;
}

}  // namespace shapespline
