// The bending energy of a curve's samples, and the samples that minimise it with the keys held: what cubic splines do
// in closed form (paper Eq. 1-2, Fig. 2). The energy is separable, so one matrix of weights serves every coordinate.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/status.h"
#include "core/spline/spline.h"

namespace shapespline {

/// a b, without the code that makes large products fast.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// K evenly spaced samples x_i of a curve's range, h apart: of a periodic curve those of one period, which its first
/// sample follows again. Each is a row of weights over the curve's columns, so a path is a K x Columns::count() matrix.
/// The energy is the sum of |x_(i-1) - 2 x_i + x_(i+1)|^2 / h^3 over the inner samples; with Hermite ends half a term
/// for each end too, with the neighbour beyond it that gives the assigned slope as the central difference. A key
/// between two samples is held by their linear interpolation: an error of second order in h, as that of the differences
/// themselves. (Held at the nearest sample, it would be of first order.)
class DiscreteSpline {
 public:
  /// Of the curve through keyTimes. Costs K^3. Errors: InvalidOption (fewer samples than one for each of the shortest
  /// intervals between keys, or more than mostSamples).
  static Result<DiscreteSpline> fit(const std::vector<double>& keyTimes, BoundaryKind boundary, const Curve& curve,
                                    int samples);

  static constexpr int mostSamples = 1000;

  const std::vector<double>& times() const { return times_; }

  /// The path of least energy.
  const Eigen::MatrixXd& weights() const { return weights_; }

  /// Energy of a path. gram: inner products of the columns, for one coordinate v v^T with its values v in them.
  double energy(const Eigen::MatrixXd& path, const Eigen::MatrixXd& gram) const;

  /// Derivative of half the energy by each sample, as weights: its inner product with a change of the path. It vanishes
  /// at the minimum for every change that keeps the keys.
  Eigen::MatrixXd gradient(const Eigen::MatrixXd& path) const;

  /// What the keys hold: one row per key, the sample's or the two samples' shares. holds() times a change that keeps
  /// the keys is 0.
  const Eigen::MatrixXd& holds() const { return holds_; }

 private:
  Eigen::MatrixXd bend(const Eigen::MatrixXd& path) const { return product(differences_, path) + assigned_; }

  std::vector<double> times_;
  Eigen::MatrixXd differences_;  // second differences over h^(3/2): one row each, of the samples
  Eigen::MatrixXd assigned_;     // what the boundary adds to them: weights over the columns
  Eigen::MatrixXd holds_, weights_;
};

}  // namespace shapespline
