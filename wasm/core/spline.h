// Cubic splines as weights: the curve at time t is an affine combination of the keys, the same one for every entry of a
// coordinate vector (paper Eq. 1-2 and 6; section 3.2).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/options.h"
#include "core/status.h"

namespace shapespline {

/// How a periodic curve closes.
enum class Closing {
  LastKey,  ///< the last key is the first one again, up to a rigid motion: the period is t_J - t_1
  Extra,    ///< the curve runs on from the last key to the first over an interval of its own
};

struct CurveOptions {
  bool linear = false;             ///< piecewise linear instead of cubic
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1, endSpeed = 1;
  bool startShape = false;         ///< hermite: the start tangent column takes key 2's place in the difference at key 1
  bool endShape = false;           ///< hermite: the end tangent column takes key J - 1's place in the difference at key J
  Closing closing = Closing::Extra;
  std::optional<double> period = {};
  std::vector<double> tension = {};
  std::vector<double> bias = {};
};

/// The columns that a weight vector of J keys ranges over: keys 0 to J - 1, then these.
struct Columns {
  int keys;
  int startTangent() const { return keys; }
  int endTangent() const { return keys + 1; }
  int closing() const { return keys + 2; }  ///< key 1 as the curve meets it again after one period
  int count() const { return keys + 3; }
};

/// Columns::count() entries; they sum to 1 (a derivative's to 0).
struct Weights : Eigen::VectorXd {
  using Eigen::VectorXd::VectorXd;
  template <class Derived>
  Weights(const Eigen::MatrixBase<Derived>& entries) : Eigen::VectorXd(entries) {}

  int beyond = -1;  ///< end key that the curve goes on from straight, or -1 within its knots
};

/// A time taken back into one period.
struct WrappedTime {
  double time;
  int periods = 0;  ///< whole periods that were taken off
};

/// A fitted curve: knots and the slope at each as a combination of the columns. Immutable.
class Curve {
 public:
  /// times: J >= 2, strictly increasing. Errors: InvalidOption (period too short, tensions or biases of another count,
  /// a bias outside [-1, 1], speeds or numbers that are not finite), TimesNotIncreasing, TimeCountMismatch.
  static Result<Curve> fit(const std::vector<double>& times, const CurveOptions& options);

  /// Weights of the value (derivative 0) or of its first or second derivative at time t. Outside the knots: linear from
  /// the end derivative, and marked so. A periodic curve is only defined on its knots: wrap() first.
  Weights weights(double t, int derivative = 0) const;

  WrappedTime wrap(double t) const;

  /// First and last knot: the key range, for a periodic curve one whole period.
  double start() const { return knots_.front(); }
  double end() const { return knots_.back(); }
  bool periodic() const { return periodic_; }

 private:
  Columns columns_{0};
  std::vector<double> knots_;
  Eigen::MatrixXd value_;  // knots x columns
  Eigen::MatrixXd slope_;  // knots x columns
  bool linear_ = false, periodic_ = false;
};

/// The period that a periodic curve gets where none is asked for: t_J - t_1 where the last key closes it, otherwise one
/// mean spacing more.
double defaultPeriod(const std::vector<double>& times, Closing closing);

}  // namespace shapespline
