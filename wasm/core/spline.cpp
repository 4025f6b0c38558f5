#include "core/spline.h"

#include <algorithm>
#include <cmath>

#include "core/keyframes.h"
#include "core/text.h"

namespace shapespline {

namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Solves a tridiagonal system with a matrix of right-hand sides (Thomas). The spline systems are diagonally dominant, so
// that no pivoting is needed.
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

// The same with corners lower[0] (at row 0, last column) and upper[n - 1] (at the last row, column 0), by Sherman and
// Morrison's formula. n >= 3.
MatrixXd solveCyclic(const VectorXd& lower, VectorXd diagonal, const VectorXd& upper, const MatrixXd& rhs) {
  const Eigen::Index n = diagonal.size();
  const double alpha = upper[n - 1], beta = lower[0], gamma = -diagonal[0];
  diagonal[0] -= gamma;
  diagonal[n - 1] -= alpha * beta / gamma;
  VectorXd u = VectorXd::Zero(n);
  u[0] = gamma, u[n - 1] = alpha;
  const MatrixXd y = solveTridiagonal(lower, diagonal, upper, rhs);
  const VectorXd z = solveTridiagonal(lower, diagonal, upper, u);
  const RowVectorXd vy = y.row(0) + (beta / gamma) * y.row(n - 1);
  const double vz = z[0] + (beta / gamma) * z[n - 1];
  return y - z * (vy / (1 + vz));
}

struct Spans {
  VectorXd h;        // knots - 1
  MatrixXd secant;   // difference quotients, (knots - 1) x columns
};

Spans spansOf(const std::vector<double>& knots, const MatrixXd& value) {
  const auto n = static_cast<Eigen::Index>(knots.size());
  Spans spans{VectorXd(n - 1), MatrixXd(n - 1, value.cols())};
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    spans.h[i] = knots[i + 1] - knots[i];
    spans.secant.row(i) = (value.row(i + 1) - value.row(i)) / spans.h[i];
  }
  return spans;
}

// Slopes of the C2 spline: continuity of the second derivative at inner knots, a boundary row at either end.
MatrixXd openSlopes(const Spans& s, const CurveOptions& options, const RowVectorXd& startSlope, const RowVectorXd& endSlope) {
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

// Slopes of the periodic spline: first and second derivative agree where the curve closes.
MatrixXd periodicSlopes(const Spans& s) {
  const Eigen::Index n = s.h.size();  // as many unknown slopes as intervals
  MatrixXd slopes(n + 1, s.secant.cols());
  VectorXd lower(n), diagonal(n), upper(n);
  MatrixXd rhs(n, s.secant.cols());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = (i + n - 1) % n;
    lower[i] = 1 / s.h[before];
    upper[i] = 1 / s.h[i];
    diagonal[i] = 2 * (lower[i] + upper[i]);
    rhs.row(i) = 3 * (s.secant.row(before) * lower[i] + s.secant.row(i) * upper[i]);
  }
  if (n == 1) {
    slopes.row(0) = s.secant.row(0);
  } else if (n == 2) {  // both neighbours are the same knot: the matrix is [d, o; o, d]
    const double d = diagonal[0], o = lower[0] + upper[0], determinant = d * d - o * o;
    slopes.row(0) = (d * rhs.row(0) - o * rhs.row(1)) / determinant;
    slopes.row(1) = (d * rhs.row(1) - o * rhs.row(0)) / determinant;
  } else {
    slopes.topRows(n) = solveCyclic(lower, diagonal, upper, rhs);
  }
  slopes.row(n) = slopes.row(0);
  return slopes;
}

Status checkOptions(const CurveOptions& o, int keyCount) {
  if (!std::isfinite(o.startSpeed) || !std::isfinite(o.endSpeed))
    return Error{ErrorCode::InvalidOption, "A Hermite speed is not a finite number. Use 0 to ease, 1 for the default."};
  if (!o.tension.empty() && static_cast<int>(o.tension.size()) != keyCount)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(o.tension.size()) + " tensions for " +
                                               grouped(keyCount) + " keys. Give one a key, or none."};
  for (double tension : o.tension)
    if (!std::isfinite(tension)) return Error{ErrorCode::InvalidOption, "A tension is not a finite number."};
  if (!o.bias.empty() && static_cast<int>(o.bias.size()) != keyCount)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(o.bias.size()) + " biases for " + grouped(keyCount) +
                                               " keys. Give one a key, or none."};
  for (double bias : o.bias)
    if (!(std::abs(bias) <= 1)) return Error{ErrorCode::InvalidOption, "A bias is not a number from -1 to 1."};
  return {};
}

// Bias and tension at one knot: a share |bias| of the C2 slope gives way to the one-sided difference, before the knot for a
// positive bias and after it for a negative one, as in Kochanek and Bartels (1984), whose splines start from the mean of
// the two; then the whole is scaled. All of it is linear in the columns, so that the weights stay affine. 0 leaves the
// slope as it is, bit for bit; anything else costs the continuity of the second derivative there, never of the first.
void shapeSlope(MatrixXd& slope, const Spans& s, Eigen::Index knot, double bias, double tension, bool closed) {
  const Eigen::Index spans = s.h.size();
  if (bias != 0) {
    const Eigen::Index before = knot > 0 ? knot - 1 : (closed ? spans - 1 : 0);
    const Eigen::Index after = knot < spans ? knot : (closed ? 0 : spans - 1);
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
  curve.knots_ = times;
  Closing closing = options.closing;
  if (curve.periodic_) {
    const double span = times.back() - times.front();
    const double period = options.period.value_or(defaultPeriod(times, closing));
    const bool spansKeys = std::abs(period - span) <= 1e-9 * span;
    if (closing == Closing::LastKey && !spansKeys) closing = Closing::Extra;
    if (closing == Closing::Extra) {
      if (!(period > span) || spansKeys || !std::isfinite(period))
        return Error{ErrorCode::InvalidOption, "The period " + shortNumber(period) +
                                                   " is not longer than the time from the first key to the last, " +
                                                   shortNumber(span) + ". Choose a longer period or move the keys."};
      curve.knots_.push_back(times.front() + period);
    }
  }

  const auto knotCount = static_cast<Eigen::Index>(curve.knots_.size());
  curve.value_ = MatrixXd::Zero(knotCount, curve.columns_.count());
  for (int j = 0; j < keys; ++j) curve.value_(j, j) = 1;
  if (knotCount > keys) curve.value_(keys, curve.columns_.closing()) = 1;

  const Spans spans = spansOf(curve.knots_, curve.value_);
  if (options.linear) return curve;
  if (curve.periodic_) {
    curve.slope_ = periodicSlopes(spans);
  } else {
    RowVectorXd start = spans.secant.row(0), end = spans.secant.row(keys - 2);
    if (options.startShape) {
      start.setZero();
      start[curve.columns_.startTangent()] = 1 / spans.h[0];
      start[0] = -1 / spans.h[0];
    }
    if (options.endShape) {
      end.setZero();
      end[keys - 1] = 1 / spans.h[keys - 2];
      end[curve.columns_.endTangent()] = -1 / spans.h[keys - 2];
    }
    curve.slope_ = openSlopes(spans, options, options.startSpeed * start, options.endSpeed * end);
  }
  // The last knot of a closed curve is its first again.
  const auto at = [&](const std::vector<double>& values, Eigen::Index i) {
    return values.empty() ? 0 : values[curve.periodic_ && i + 1 == knotCount ? 0 : i];
  };
  for (Eigen::Index i = 0; i < knotCount; ++i)
    shapeSlope(curve.slope_, spans, i, at(options.bias, i), at(options.tension, i), curve.periodic_);
  return curve;
}

Weights Curve::weights(double t, int derivative) const {
  const Eigen::Index last = static_cast<Eigen::Index>(knots_.size()) - 1;
  const auto upper = std::upper_bound(knots_.begin(), knots_.end(), t) - knots_.begin();
  const Eigen::Index i = std::clamp<Eigen::Index>(upper - 1, 0, last - 1);
  const double h = knots_[i + 1] - knots_[i];
  const double u = (t - knots_[i]) / h;
  const auto value = [&](const RowVectorXd& row) {
    Weights weights = row.transpose();
    if (!periodic_ && (u < 0 || u > 1)) weights.beyond = u < 0 ? 0 : columns_.keys - 1;
    return weights;
  };
  if (linear_) {
    const RowVectorXd secant = (value_.row(i + 1) - value_.row(i)) / h;
    if (derivative == 0) return value((1 - u) * value_.row(i) + u * value_.row(i + 1));
    return derivative == 1 ? Weights(secant.transpose()) : Weights(Weights::Zero(columns_.count()));
  }
  if (u < 0 || u > 1) {  // beyond the ends (paper section 3.2): f(t) = f(t_e) + f'(t_e) (t - t_e)
    const Eigen::Index e = u < 0 ? 0 : last;
    if (derivative == 0) return value(value_.row(e) + (t - knots_[e]) * slope_.row(e));
    return derivative == 1 ? Weights(slope_.row(e).transpose()) : Weights(Weights::Zero(columns_.count()));
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
  return (v0 * value_.row(i) + v1 * value_.row(i + 1) + s0 * slope_.row(i) + s1 * slope_.row(i + 1)).transpose();
}

WrappedTime Curve::wrap(double t) const {
  if (!periodic_ || (t >= start() && t <= end())) return {t, 0};
  const double period = end() - start();
  const double turns = std::floor((t - start()) / period);
  const double time = std::clamp(t - turns * period, start(), end());
  return {time, static_cast<int>(std::clamp(turns, -1e9, 1e9))};
}

}  // namespace shapespline
