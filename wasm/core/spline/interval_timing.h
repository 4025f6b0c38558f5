// When a motion passes from one key to the next, and how far it swings out between them: two numbers per interval.
#pragma once

#include <span>

#include <Eigen/Core>

#include "core/spline/slope_rows.h"

namespace shapespline {

/// For interval k of length h_k with middle m_k, between the knots k and k + 1 of a spline with weights w(t):
///
///   w_timed(t) = w(t) + sum_k beta_k(t) (a_k A_k + b_k B_k)
///   A_k = h_k w'(m_k)                          earlier: one unit is one interval at the speed in the middle
///   B_k = w(m_k) - (d_k + d_(k+1)) / 2         swing: -1 is straight, 1 twice as far; d_k is the weight 1 of knot k
///
/// beta_k is a cubic spline with knots at all knots and middles: 1 at m_k, 0 at the others, with slope 0 at the first
/// and last knot. Its slopes at a key are scaled by 1 - tension, so a key with tension 1 stops. The weights keep their
/// sum, every key is met exactly, and nothing changes beyond the knots. Without tension, the timed weights are as
/// smooth as w between the first and the last knot.
class IntervalTiming {
 public:
  /// a_k and b_k, one per interval.
  struct Numbers {
    Eigen::VectorXd earlier, swing;
  };

  /// tension: one per knot.
  IntervalTiming(const Eigen::VectorXd& knots, const Eigen::VectorXd& tension);

  /// Adds the sum above, or its first or second derivative. plain: the spline with weights w.
  void addWeights(const KnotSpline& plain, const Numbers& numbers, double t, int derivative, Weights& weights) const;

 private:
  KnotSpline beta_;
};

}  // namespace shapespline
