#include "core/spline/spline.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "core/spline/key_times.h"

namespace shapespline {

namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Solves a tridiagonal system with several right-hand sides (Thomas algorithm). The spline systems are diagonally
// dominant, so they need no pivoting.
MatrixXd solveTridiagonal(const VectorXd& lower, VectorXd diagonal, const VectorXd& upper, MatrixXd rhs) {
  const Eigen::Index n = diagonal.size();
  for (Eigen::Index i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    rhs.row(i) -= factor * rhs.row(i - 1);
  }
  rhs.row(n - 1) /= diagonal[n - 1];
  for (Eigen::Index i = n - 2; i >= 0; --i) rhs.row(i) = (rhs.row(i) - upper[i] * rhs.row(i + 1)) / diagonal[i];
  return rhs;
}

// Number of keys beyond each end of a period that noticeably affect it. From key to key, the influence on a cubic
// spline falls to 0.27 of its value for even spacing, and to at most half for any spacing.
constexpr int knotsBeyond = 40;

struct Spans {
  VectorXd h;       // interval lengths, knots - 1
  MatrixXd secant;  // difference quotients, (knots - 1) x columns
};

// columns: the knots, followed by the two tangents.
Spans spansOf(const VectorXd& times) {
  const Eigen::Index n = times.size();
  Spans spans{VectorXd(n - 1), MatrixXd::Zero(n - 1, n + 2)};
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    spans.h[i] = times[i + 1] - times[i];
    spans.secant(i, i + 1) = 1 / spans.h[i];
    spans.secant(i, i) = -1 / spans.h[i];
  }
  return spans;
}

// Slopes of the C2 spline: continuous second derivative at inner knots, a boundary condition at either end.
MatrixXd openSlopes(const Spans& s, const CurveOptions& options, const RowVectorXd& startSlope,
                    const RowVectorXd& endSlope) {
  const Eigen::Index n = s.h.size() + 1;
  VectorXd lower = VectorXd::Zero(n), diagonal(n), upper = VectorXd::Zero(n);
  MatrixXd rhs(n, s.secant.cols());
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    lower[i] = 1 / s.h[i - 1];
    upper[i] = 1 / s.h[i];
    diagonal[i] = 2 * (lower[i] + upper[i]);
    rhs.row(i) = 3 * (s.secant.row(i - 1) * lower[i] + s.secant.row(i) * upper[i]);
  }
  if (options.boundary == BoundaryKind::Hermite) {
    diagonal[0] = diagonal[n - 1] = 1;
    rhs.row(0) = startSlope;
    rhs.row(n - 1) = endSlope;
  } else {  // natural: zero second derivative
    diagonal[0] = diagonal[n - 1] = 2;
    upper[0] = lower[n - 1] = 1;
    rhs.row(0) = 3 * s.secant.row(0);
    rhs.row(n - 1) = 3 * s.secant.row(n - 2);
  }
  return solveTridiagonal(lower, diagonal, upper, rhs);
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
void shapeSlope(MatrixXd& slope, const Spans& s, Eigen::Index knot, double bias, double tension) {
  if (bias != 0) {
    const Eigen::Index before = std::max<Eigen::Index>(knot - 1, 0), after = std::min(knot, s.h.size() - 1);
    slope.row(knot) = (1 - std::abs(bias)) * slope.row(knot) + std::abs(bias) * s.secant.row(bias > 0 ? before : after);
  }
  if (tension != 0) slope.row(knot) *= 1 - tension;
}

}  // namespace

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

  const auto count = static_cast<Eigen::Index>(curve.knots_.size());
  VectorXd knotTimes(count);
  for (Eigen::Index i = 0; i < count; ++i) knotTimes[i] = curve.knots_[i].time;
  const Spans spans = spansOf(knotTimes);
  if (options.linear) return curve;
  RowVectorXd start = spans.secant.row(0), end = spans.secant.row(count - 2);
  if (!curve.periodic_ && options.startShape) {
    start.setZero();
    start[count] = 1 / spans.h[0];
    start[0] = -1 / spans.h[0];
  }
  if (!curve.periodic_ && options.endShape) {
    end.setZero();
    end[count - 1] = 1 / spans.h[count - 2];
    end[count + 1] = -1 / spans.h[count - 2];
  }
  curve.slope_ = openSlopes(spans, options, options.startSpeed * start, options.endSpeed * end);
  const auto at = [&](const std::vector<double>& values, Eigen::Index i) {
    return values.empty() ? 0 : values[curve.knots_[i].key];
  };
  for (Eigen::Index i = 0; i < count; ++i)
    shapeSlope(curve.slope_, spans, i, at(options.bias, i), at(options.tension, i));
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
  const auto last = static_cast<Eigen::Index>(knots_.size()) - 1;
  const auto upper =
      std::upper_bound(knots_.begin(), knots_.end(), t, [](double time, const Knot& k) { return time < k.time; }) -
      knots_.begin();
  const Eigen::Index i = std::clamp<Eigen::Index>(upper - 1, 0, last - 1);
  const double h = knots_[i + 1].time - knots_[i].time;
  const double u = (t - knots_[i].time) / h;
  Weights result = Weights::Zero(last + 3);
  if (linear_) {
    if (derivative == 0) result[i] = 1 - u, result[i + 1] = u;
    if (derivative == 1) result[i] = -1 / h, result[i + 1] = 1 / h;
    return result;
  }
  if (u < 0 || u > 1) {  // beyond the ends (paper section 3.2): f(t) = f(t_e) + f'(t_e) (t - t_e)
    const Eigen::Index e = u < 0 ? 0 : last;
    if (derivative == 0) {
      result = (t - knots_[e].time) * slope_.row(e).transpose();
      result[e] += 1;
    }
    if (derivative == 1) result = slope_.row(e).transpose();
    return result;
  }
  double v0, v1, s0, s1;  // cubic Hermite basis and its derivatives
  if (derivative == 0) {
    const double w = 1 - u;
    v0 = w * w * (1 + 2 * u), v1 = u * u * (3 - 2 * u);
    s0 = h * u * w * w, s1 = -h * u * u * w;
  } else if (derivative == 1) {
    v1 = 6 * u * (1 - u) / h, v0 = -v1;
    s0 = (1 - u) * (1 - 3 * u), s1 = u * (3 * u - 2);
  } else {
    v1 = (6 - 12 * u) / (h * h), v0 = -v1;
    s0 = (6 * u - 4) / h, s1 = (6 * u - 2) / h;
  }
  result = (s0 * slope_.row(i) + s1 * slope_.row(i + 1)).transpose();
  result[i] += v0;
  result[i + 1] += v1;
  return result;
}

Weights Curve::addUp(const Weights& atKnots) const {
  const auto count = static_cast<Eigen::Index>(knots_.size());
  Weights result = Weights::Zero(columns_.count());
  for (Eigen::Index i = 0; i < count; ++i) result[knots_[i].key] += atKnots[i];
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
    share += atEach[static_cast<Eigen::Index>(i)];
    steps[i - 1] = {knots_[i - 1].step, share, knots_[i - 1].period};
  }
  gatherSteps(point, steps, 0, 0, {columns_.keys});
  const Knot& base = knots_[point.base];
  point.base = base.key;
  point.basePeriod = base.period;
  for (std::size_t i = 0; i < knots_.size(); ++i)
    if (const double w = atEach[static_cast<Eigen::Index>(i)]; w != 0)
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
    const double weight = weights[static_cast<Eigen::Index>(i)];
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
