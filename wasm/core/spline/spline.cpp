#include "core/spline/spline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/format.h"
#include "core/spline/key_times.h"

namespace shapespline {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Number of keys beyond each end of a period that noticeably affect it. From key to key, the influence on a cubic
// spline falls to 0.27 of its value for even spacing, and to at most half for any spacing.
constexpr int knotsBeyond = 40;

// names: of the values, in the plural. Error: InvalidOption (wrong number of values, or one that is not finite).
Status checkPerKey(const std::vector<double>& values, int keys, const char* name, const char* names) {
  if (!values.empty() && static_cast<int>(values.size()) != keys)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(values.size()) + " " + names + " for " +
                                               grouped(keys) + " keys. Give one per key, or none."};
  for (const double value : values)
    if (!std::isfinite(value)) return Error{ErrorCode::InvalidOption, std::string(name) + " is not a finite number."};
  return {};
}

bool isZero(const IntervalTiming::Numbers& timing) { return timing.earlier.isZero(0) && timing.swing.isZero(0); }

Status checkTiming(const KeyTiming& timing, int keys) {
  if (Status status = checkPerKey(timing.earlier, keys, "A value of earlier", "values of earlier"); !status)
    return status;
  return checkPerKey(timing.swing, keys, "A value of swing", "values of swing");
}

Status checkOptions(const CurveOptions& o, int keys) {
  if (!std::isfinite(o.startSpeed) || !std::isfinite(o.endSpeed))
    return Error{ErrorCode::InvalidOption, "A Hermite speed is not a finite number. Use 0 to ease, 1 for the default."};
  if (Status status = checkPerKey(o.tension, keys, "A tension", "tensions"); !status) return status;
  if (Status status = checkPerKey(o.bias, keys, "A bias", "biases"); !status) return status;
  if (Status status = checkTiming(o.timing, keys); !status) return status;
  for (const KeyTiming& part : o.parts)
    if (Status status = checkTiming(part, keys); !status) return status;
  for (const double bias : o.bias)
    if (std::abs(bias) > 1) return Error{ErrorCode::InvalidOption, "A bias must be a number from -1 to 1."};
  return {};
}

}  // namespace

// Not inlined, because each is long and none is called often.
[[gnu::noinline]] CurvePoint::CurvePoint() = default;
[[gnu::noinline]] CurvePoint::CurvePoint(const CurvePoint&) = default;
[[gnu::noinline]] CurvePoint::CurvePoint(CurvePoint&&) noexcept = default;
[[gnu::noinline]] CurvePoint& CurvePoint::operator=(const CurvePoint&) = default;
[[gnu::noinline]] CurvePoint& CurvePoint::operator=(CurvePoint&&) noexcept = default;
[[gnu::noinline]] CurvePoint::~CurvePoint() = default;

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
  const VectorXd bias = curve.ofKnots(options.bias), tension = curve.ofKnots(options.tension);
  if (!options.linear) {
    curve.spline_ = KnotSpline::fit(knotTimes, options);
    for (Index i = 0; i < count; ++i) curve.spline_.shapeSlope(i, bias[i], tension[i]);
    curve.timing_ = curve.ofIntervals(options.timing);
    bool plain = isZero(curve.timing_);
    for (const KeyTiming& part : options.parts) {
      curve.parts_.push_back(curve.ofIntervals(part));
      plain = plain && isZero(curve.parts_.back());
    }
    if (!plain) curve.timer_.emplace(knotTimes, tension);
  }
  return curve;
}

VectorXd Curve::ofKnots(const std::vector<double>& ofKeys) const {
  VectorXd values = VectorXd::Zero(static_cast<Index>(knots_.size()));
  if (!ofKeys.empty())
    for (Index i = 0; i < values.size(); ++i) values[i] = ofKeys[knots_[i].key];
  return values;
}

IntervalTiming::Numbers Curve::ofIntervals(const KeyTiming& timing) const {
  const Index intervals = static_cast<Index>(knots_.size()) - 1;
  return {ofKnots(timing.earlier).head(intervals), ofKnots(timing.swing).head(intervals)};
}

Curve Curve::withoutTiming() const {
  Curve plain = *this;
  plain.timer_.reset();
  plain.parts_.clear();
  return plain;
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

Weights Curve::atKnots(double t, int derivative, const IntervalTiming::Numbers& timing) const {
  Weights result = Weights::Zero(static_cast<Index>(knots_.size()) + 2);
  if (!linear_) {
    spline_.addWeights(t, derivative, 1, result);
    if (timer_) timer_->addWeights(spline_, timing, t, derivative, result);
    return result;
  }
  const auto last = static_cast<Index>(knots_.size()) - 1;
  const auto upper =
      std::upper_bound(knots_.begin(), knots_.end(), t, [](double time, const Knot& k) { return time < k.time; }) -
      knots_.begin();
  const Index i = std::clamp<Index>(upper - 1, 0, last - 1);
  const double h = knots_[i + 1].time - knots_[i].time;
  const double u = (t - knots_[i].time) / h;
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

Weights Curve::addUp(const Weights& atKnots) const {
  const auto count = static_cast<Index>(knots_.size());
  Weights result = Weights::Zero(columns_.count());
  for (Index i = 0; i < count; ++i) result[knots_[i].key] += atKnots[i];
  result.tail<2>() = atKnots.tail<2>();
  return result;
}

Weights Curve::weights(double t, int derivative) const { return addUp(atKnots(t, derivative, timing_)); }

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

CurvePoint Curve::pointAt(double t, const IntervalTiming::Numbers& timing) const {
  const Weights atEach = atKnots(t, 0, timing);
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
  const Weights weights = atKnots(t, 1, timing_);
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
