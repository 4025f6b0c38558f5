// The bending energy of a sampled curve, and its minimiser through the keys. Cubic splines solve the same problem in
// closed form (paper Eq. 1-2, Fig. 2). The energy is separable, so one matrix of weights serves every coordinate.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/status.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Product a b, without Eigen's code for large matrices.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// K samples x_i of a curve, evenly spaced by h: over its range, or over one period, after which the first sample
/// follows. Each sample is a row of weights over the curve's columns, so a path is a K x Columns::count() matrix.
/// The energy is the sum of |x_(i-1) - 2 x_i + x_(i+1)|^2 / h^3 over the inner samples. Hermite ends add half a term
/// each, with an outer neighbour such that the central difference is the assigned slope. A key between two samples is
/// held by their linear interpolation, with an error of second order in h, like the differences themselves. (Holding
/// the nearest sample would be first order.)
class DiscreteSpline {
 public:
  /// Samples the curve through keyTimes. Costs K^3. Errors: InvalidOption (fewer than four samples, fewer than one per
  /// shortest interval between keys, or more than maxSamples).
  static Result<DiscreteSpline> fit(const std::vector<double>& keyTimes, BoundaryKind boundary, const Curve& curve,
                                    int samples);

  static constexpr int maxSamples = 1000;

  const std::vector<double>& times() const { return times_; }

  /// The path of minimum energy.
  const Eigen::MatrixXd& weights() const { return weights_; }

  /// Energy of a path. gram: inner products of the columns; for a single coordinate with values v, v v^T.
  double energy(const Eigen::MatrixXd& path, const Eigen::MatrixXd& gram) const;

  /// Derivative of half the energy by each sample, as weights: its inner product with a change of the path. At the
  /// minimum it vanishes for every change that keeps the keys.
  Eigen::MatrixXd gradient(const Eigen::MatrixXd& path) const;

  /// Constraints of the keys: one row per key, with the shares of its one or two samples. holds() times a change that
  /// keeps the keys is 0.
  const Eigen::MatrixXd& holds() const { return holds_; }

 private:
  Eigen::MatrixXd bend(const Eigen::MatrixXd& path) const { return product(differences_, path) + assigned_; }

  std::vector<double> times_;
  Eigen::MatrixXd differences_;  // second differences over h^(3/2), one row each, as weights over the samples
  Eigen::MatrixXd assigned_;     // contribution of the boundary, as weights over the columns
  Eigen::MatrixXd holds_, weights_;
};

}  // namespace shapespline
