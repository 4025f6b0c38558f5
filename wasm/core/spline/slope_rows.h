// Slopes of cubic splines as weights of their knots (paper Eq. 1-2 and 6).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/spline/curve_options.h"

namespace shapespline {

using Weights = Eigen::VectorXd;  ///< one per knot or column, then two for end tangents; sum 1 (0 for a derivative)

/// The slope at each knot as weights of the nearest knots and of the shapes for end tangents.
class SlopeRows {
 public:
  using Index = Eigen::Index;
  explicit SlopeRows(Index knots);

  /// The weight of a near knot in the slope at knot i.
  double& operator()(Index i, Index knot) { return row(i)[knot - first(i)]; }
  double& startTangent(Index i) { return row(i)[width_]; }
  double& endTangent(Index i) { return row(i)[width_ + 1]; }
  /// All weights in the slope at knot i.
  std::span<double> row(Index i) { return std::span(rows_).subspan(i * (width_ + 2), width_ + 2); }
  /// Subtracts a multiple of the slope at a neighbouring knot j.
  void subtract(Index i, double factor, Index j);
  /// Adds a multiple of the slope at knot i to weights of all knots and tangents.
  void addTo(Weights& weights, Index i, double factor) const;

 private:
  Index first(Index i) const;  // the first knot with a weight in row i

  Index knots_, width_;
  std::vector<double> rows_;
};

/// A cubic spline through knots, given by the slope at each.
class KnotSpline {
 public:
  using Index = Eigen::Index;
  KnotSpline() = default;

  /// The C2 spline with the natural or Hermite ends of `options`. times: at least two, strictly increasing.
  static KnotSpline fit(Eigen::VectorXd times, const CurveOptions& options);

  /// Shapes the slope at one knot. The one-sided difference replaces a share |bias| of it: the difference before the
  /// knot for a positive bias, after it for a negative bias. Kochanek and Bartels (1984) do the same, starting from the
  /// mean of the two differences. Then the slope is scaled by 1 - tension. Both steps are linear in the columns, so the
  /// weights stay affine. 0 leaves the slope unchanged, bit for bit. Other values make the second derivative
  /// discontinuous there, but never the first.
  void shapeSlope(Index knot, double bias, double tension);

  /// Scales slopes, as tension does, and then makes the second derivative continuous at all other inner knots again.
  /// tension: one per knot. ends: as for fit().
  void scaleSlopes(const Eigen::VectorXd& tension, const CurveOptions& ends);

  /// Adds `factor` times the weights of the value (derivative 0) or of its first or second derivative at time t. Beyond
  /// the knots, the spline is linear with the end derivative (paper section 3.2).
  void addWeights(double t, int derivative, double factor, Weights& weights) const;

  const Eigen::VectorXd& times() const { return times_; }

 private:
  Eigen::VectorXd times_;
  SlopeRows slope_{0};
};

/// The interval that contains t, or the nearest one.
Eigen::Index intervalAt(const Eigen::VectorXd& times, double t);

}  // namespace shapespline
