#include "core/spline/spline.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "core/spline/key_times.h"

namespace shapespline {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Farthest knots with a weight in the slope at a knot. From knot to knot, weights fall at least to half, so a farther
// one is less than 1e-38 of the nearest. Shorter curves have all weights.
constexpr Index farthestKnot = 128;

// Number of keys beyond each end of a period that noticeably affect it. From key to key, the influence on a cubic
// spline falls to 0.27 of its value for even spacing, and to at most half for any spacing.
constexpr int knotsBeyond = 40;

// Difference quotients: 1 / h per interval between knots.
VectorXd quotientsOf(const VectorXd& times) {
  VectorXd quotient(times.size() - 1);
  for (Index i = 0; i < quotient.size(); ++i) quotient[i] = 1 / (times[i + 1] - times[i]);
  return quotient;
}

// Adds `factor` times the difference quotient of an interval to the slope at a knot.
void addSecant(SlopeRows& slope, Index knot, Index interval, double factor, const VectorXd& quotient) {
  slope(knot, interval) += factor * -quotient[interval];
  slope(knot, interval + 1) += factor * quotient[interval];
}

// Slopes of the C2 spline: continuous second derivative at inner knots, a boundary condition at either end.
SlopeRows openSlopes(const VectorXd& quotient, const CurveOptions& options) {
  const Index n = quotient.size() + 1, last = n - 1;
  VectorXd lower = VectorXd::Zero(n), diagonal(n), upper = VectorXd::Zero(n);
  SlopeRows rhs(n);
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
    addSecant(rhs, 0, 0, 3, quotient);
    addSecant(rhs, last, last - 1, 3, quotient);
  }
  // Thomas algorithm. The systems are diagonally dominant, so they need no pivoting.
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
  return rhs;
}

Status checkOptions(const CurveOptions& o, int keyCount) {
  if (!std::isfinite(o.startSpeed) || !std::isfinite(o.endSpeed))
    return Error{ErrorCode::InvalidOption, "A Hermite speed is not a finite number. Use 0 to ease, 1 for the default."};
  if (!o.tension.empty() && static_cast<int>(o.tension.size()) != keyCount)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(o.tension.size()) + " tensions for " +
                                               grouped(keyCount) + " keys. Give one per key, or none."};
  for (double tension : o.tension)
    if (!std::isfinite(tension)) return Error{ErrorCode::InvalidOption, "A tension is not a finite number."};
  if (!o.bias.empty() && static_cast<int>(o.bias.size()) != keyCount)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(o.bias.size()) + " biases for " + grouped(keyCount) +
                                               " keys. Give one per key, or none."};
  for (double bias : o.bias)
    if (!(std::abs(bias) <= 1)) return Error{ErrorCode::InvalidOption, "A bias must be a number from -1 to 1."};
  return {};
}

// Applies bias and tension at one knot. A share |bias| of the C2 slope is replaced by the one-sided difference, before
// the knot for a positive bias and after it for a negative bias. Kochanek and Bartels (1984) do the same, starting from
// the mean of the two differences. Then the slope is scaled. Both steps are linear in the columns, so the weights stay
// affine. 0 leaves the slope unchanged, bit for bit. Other values make the second derivative discontinuous there, but
// never the first.
void shapeSlope(SlopeRows& slope, const VectorXd& quotient, Index knot, double bias, double tension) {
  if (bias != 0) {
    const Index before = std::max<Index>(knot - 1, 0), after = std::min(knot, quotient.size() - 1);
    for (double& w : slope.row(knot)) w *= 1 - std::abs(bias);
    addSecant(slope, knot, bias > 0 ? before : after, std::abs(bias), quotient);
  }
  if (tension != 0)
    for (double& w : slope.row(knot)) w *= 1 - tension;
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

double defaultPeriod(const std::vector<double>& times, Closing closing) {
  const double span = times.back() - times.front();
  return closing == Closing::LastKey ? span : span + span / static_cast<double>(times.size() - 1);
}

Result<Curve> Curve::fit(const std::vector<double>& times, const CurveOptions& options) {
  const int keys = static_cast<int>(times.size());
  if (Status status = validateTimes(times, keys); !status) return status.error();
  if (Status status = checkOptions(options, keys); !status) return status.error();

  Curve curve;
  curve.columns_ = Columns{keys};
  curve.linear_ = options.linear;
  curve.periodic_ = options.boundary == BoundaryKind::Periodic;
  const double span = times.back() - times.front();
  double period = 0;
  if (curve.periodic_) {
    period = options.period.value_or(defaultPeriod(times, options.closing));
    const bool spansKeys = std::abs(period - span) <= 1e-9 * span;
    curve.closes_ = options.closing == Closing::Extra || !spansKeys;
    if (curve.closes_ && (!(period > span) || spansKeys || !std::isfinite(period)))
      return Error{ErrorCode::InvalidOption, "The period " + shortNumber(period) + " is " +
                                                 (period > span ? "longer by less than a billionth" : "not longer") +
                                                 " than the time from the first key to the last, " + shortNumber(span) +
                                                 ". Choose a longer period or move the keys."};
    if (!curve.closes_) period = span;
  }
  curve.start_ = times.front();
  curve.end_ = curve.closes_ ? times.front() + period : times.back();
  curve.placeKnots(times, period);

  const auto count = static_cast<Index>(curve.knots_.size());
  VectorXd knotTimes(count);
  for (Index i = 0; i < count; ++i) knotTimes[i] = curve.knots_[i].time;
  if (options.linear) return curve;
  const VectorXd quotient = quotientsOf(knotTimes);
  curve.slope_ = openSlopes(quotient, options);
  const auto at = [&](const std::vector<double>& values, Index i) {
    return values.empty() ? 0 : values[curve.knots_[i].key];
  };
  for (Index i = 0; i < count; ++i) shapeSlope(curve.slope_, quotient, i, at(options.bias, i), at(options.tension, i));
  return curve;
}

void Curve::placeKnots(const std::vector<double>& times, double period) {
  const int keys = columns_.keys;
  const KeySteps steps{keys};
  if (!periodic_) {
    for (int j = 0; j < keys; ++j) knots_.push_back({times[j], j, 0, j});
    return;
  }
  const int perPeriod = closes_ ? keys : keys - 1;  // the last key repeats the first key
  const int periods = (knotsBeyond + perPeriod - 1) / perPeriod;
  for (int p = -periods; p <= periods; ++p)
    for (int j = 0; j < perPeriod; ++j) {
      const bool last = j + 1 == perPeriod;
      knots_.push_back({times[j] + p * period, j, p, !last ? j : closes_ ? steps.closing() : steps.turnedClosing()});
    }
  knots_.push_back({times[0] + (periods + 1) * period, 0, periods + 1, -1});
}

Weights Curve::atKnots(double t, int derivative) const {
  const auto last = static_cast<Index>(knots_.size()) - 1;
  const auto upper =
      std::upper_bound(knots_.begin(), knots_.end(), t, [](double time, const Knot& k) { return time < k.time; }) -
      knots_.begin();
  const Index i = std::clamp<Index>(upper - 1, 0, last - 1);
  const double h = knots_[i + 1].time - knots_[i].time;
  const double u = (t - knots_[i].time) / h;
  Weights result = Weights::Zero(last + 3);
  if (linear_) {
    if (derivative == 0) {
      result[i] = 1 - u;
      result[i + 1] = u;
    }
    if (derivative == 1) {
      result[i] = -1 / h;
      result[i + 1] = 1 / h;
    }
    return result;
  }
  if (u < 0 || u > 1) {  // beyond the ends (paper section 3.2): f(t) = f(t_e) + f'(t_e) (t - t_e)
    const Index e = u < 0 ? 0 : last;
    if (derivative < 2) slope_.addTo(result, e, derivative == 0 ? t - knots_[e].time : 1);
    if (derivative == 0) result[e] += 1;
    return result;
  }
  double v0, v1, s0, s1;  // cubic Hermite basis and its derivatives
  if (derivative == 0) {
    const double w = 1 - u;
    v0 = w * w * (1 + 2 * u);
    v1 = u * u * (3 - 2 * u);
    s0 = h * u * w * w;
    s1 = -h * u * u * w;
  } else if (derivative == 1) {
    v1 = 6 * u * (1 - u) / h;
    v0 = -v1;
    s0 = (1 - u) * (1 - 3 * u);
    s1 = u * (3 * u - 2);
  } else {
    v1 = (6 - 12 * u) / (h * h);
    v0 = -v1;
    s0 = (6 * u - 4) / h;
    s1 = (6 * u - 2) / h;
  }
  slope_.addTo(result, i, s0);
  slope_.addTo(result, i + 1, s1);
  result[i] += v0;
  result[i + 1] += v1;
  return result;
}

Weights Curve::addUp(const Weights& atKnots) const {
  const auto count = static_cast<Index>(knots_.size());
  Weights result = Weights::Zero(columns_.count());
  for (Index i = 0; i < count; ++i) result[knots_[i].key] += atKnots[i];
  result.tail<2>() = atKnots.tail<2>();
  return result;
}

Weights Curve::weights(double t, int derivative) const { return addUp(atKnots(t, derivative)); }

namespace {

// Steps with smaller shares have no visible effect. The same limit applies to the remainder of a completed step.
constexpr double negligibleShare = 1e-12;

// Omits completed and future steps. Steps of tangents are placed next to their keys.
void gatherSteps(CurvePoint& point, const std::vector<StepShare>& steps, double startWeight, double endWeight,
                 KeySteps numbers) {
  std::size_t first = 0;
  while (startWeight == 0 && first < steps.size() && std::abs(steps[first].share - 1) < negligibleShare) ++first;
  if (startWeight != 0) point.steps.push_back({numbers.startTangent(), startWeight, 0});
  for (std::size_t i = first; i < steps.size(); ++i)
    if (std::abs(steps[i].share) >= negligibleShare) point.steps.push_back(steps[i]);
  if (endWeight != 0) point.steps.push_back({numbers.endTangent(), endWeight, 0});
  point.base = static_cast<int>(first);
}

}  // namespace

CurvePoint blendedPoint(const Weights& weights, Columns columns) {
  CurvePoint point;
  point.weights = weights;
  const double startWeight = weights[columns.startTangent()], endWeight = weights[columns.endTangent()];
  // An end tangent is the end key plus a difference, so its weight also counts for that key.
  std::vector<StepShare> steps(columns.keys - 1);
  double share = endWeight;
  for (int j = columns.keys - 1; j > 0; --j) {
    share += weights[j];
    steps[j - 1] = {j - 1, share, 0};
  }
  gatherSteps(point, steps, startWeight, endWeight, {columns.keys});
  return point;
}

CurvePoint Curve::at(double t) const {
  const Weights atEach = atKnots(t, 0);
  if (!periodic_) {
    CurvePoint point = blendedPoint(atEach, columns_);
    point.beyond = t < start_ ? 0 : t > end_ ? columns_.keys - 1 : -1;
    return point;
  }
  CurvePoint point;
  point.weights = addUp(atEach);
  point.closes = closes_;
  std::vector<StepShare> steps(knots_.size() - 1);
  double share = 0;
  for (std::size_t i = knots_.size() - 1; i > 0; --i) {
    share += atEach[static_cast<Index>(i)];
    steps[i - 1] = {knots_[i - 1].step, share, knots_[i - 1].period};
  }
  gatherSteps(point, steps, 0, 0, {columns_.keys});
  const Knot& base = knots_[point.base];
  point.base = base.key;
  point.basePeriod = base.period;
  for (std::size_t i = 0; i < knots_.size(); ++i)
    if (const double w = atEach[static_cast<Index>(i)]; w != 0)
      point.unrolled.push_back({knots_[i].key, knots_[i].period, w});
  return point;
}

std::vector<KeySpan> Curve::spans() const {
  std::vector<KeySpan> spans;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
    if (knots_[i].period == 0)
      spans.push_back({knots_[i].time, knots_[i + 1].time, knots_[i].key,
                       closesOnLastKey() && knots_[i + 1].period > 0 ? columns_.keys - 1 : knots_[i + 1].key});
  return spans;
}

std::vector<KeyWeight> Curve::slopeAt(double t) const {
  const Weights weights = atKnots(t, 1);
  std::vector<KeyWeight> slope;
  for (std::size_t i = 0; i < knots_.size() + 2; ++i) {
    const double weight = weights[static_cast<Index>(i)];
    if (weight == 0) continue;
    if (i < knots_.size()) slope.push_back({knots_[i].key, knots_[i].period, weight});
    else slope.push_back({columns_.startTangent() + static_cast<int>(i - knots_.size()), 0, weight});
  }
  return slope;
}

WrappedTime Curve::wrap(double t) const {
  if (!periodic_ || (t >= start() && t <= end())) return {t, 0};
  const double period = end() - start();
  const double turns = std::floor((t - start()) / period);
  const double time = std::clamp(t - turns * period, start(), end());
  return {time, static_cast<int>(std::clamp(turns, -1e9, 1e9))};
}

}  // namespace shapespline
