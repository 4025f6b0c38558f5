// Cubic splines as weights: the curve at time t is an affine combination of the keys, the same one for every entry of a
// coordinate vector (paper Eq. 1-2 and 6; section 3.2).
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/status.h"

namespace shapespline {

/// What holds at the ends of the curve.
enum class BoundaryKind { Natural, Hermite, Periodic };

/// How a periodic curve closes.
enum class Closing {
  LastKey,  ///< the last key is the first one again, up to a rigid motion: the period is t_J - t_1
  Extra,    ///< the curve runs on from the last key to the first over an interval of its own
};

struct CurveOptions {
  bool linear = false;  ///< piecewise linear instead of cubic
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1, endSpeed = 1;
  bool startShape = false;  ///< hermite: the start tangent column takes key 2's place in the difference at key 1
  bool endShape = false;    ///< hermite: the end tangent column takes key J - 1's place in the difference at key J
  Closing closing = Closing::Extra;
  std::optional<double> period = {};
  std::vector<double> tension = {};
  std::vector<double> bias = {};
};

/// The columns that a weight vector of J keys ranges over: keys 0 to J - 1, then the shapes that stand for end
/// tangents.
struct Columns {
  int keys;
  int startTangent() const { return keys; }
  int endTangent() const { return keys + 1; }
  int count() const { return keys + 2; }
};

using Weights = Eigen::VectorXd;  ///< Columns::count() entries; they sum to 1 (a derivative's to 0)

/// The ways from one pose to the next, each with an increment of every rotation that moves through the keys. Step s
/// leads from key s to key s + 1; the others have numbers behind those.
struct KeySteps {
  int keys;
  /// From the last key to the first, where a loop closes over an interval of its own.
  int closing() const { return keys - 1; }
  /// From the second to last key to the first as the last key has it, moved rigidly.
  int turnedClosing() const { return keys; }
  /// From the first key to the shape that gives the start tangent.
  int startTangent() const { return keys + 1; }
  /// From the last key to the shape that gives the end tangent.
  int endTangent() const { return keys + 2; }
  int count() const { return keys + 3; }
};

/// What of a step has been taken: its cumulative weight (Kim, Kim and Shin 1995), 0 before and 1 after it but for the
/// spline's overshoot.
struct StepShare {
  int step;
  double share;
  int period;  ///< of a periodic curve: how many periods after the first one the step lies
};

/// A key of a periodic curve, as often as the curve comes to it.
struct KeyWeight {
  int key, period;
  double weight;
};

/// What the curve runs through between two neighbouring keys.
struct KeySpan {
  double start, end;
  int from, to;  ///< keys
};

/// A point of the curve, for all that is linear in the keys and for all that turns.
struct CurvePoint {
  Weights weights;
  int base = 0;                  ///< key at which products of increments start: every step before it is done
  int basePeriod = 0;            ///< of a periodic curve: the period of that key
  std::vector<StepShare> steps;  ///< from there on, in the order of time; steps not begun are left out
  /// Of a periodic curve: `weights` before they were added up over the periods; else empty.
  std::vector<KeyWeight> unrolled;
  bool closes = false;  ///< whether the closing step is among those that the curve takes
  int beyond = -1;      ///< end key that the curve goes on from beyond the keys, or -1 within them
};

/// The point whose weights are given: a blend of keys that need not lie on any curve.
CurvePoint blendedPoint(const Weights& weights, Columns columns);

/// A time taken back into one period.
struct WrappedTime {
  double time;
  int periods = 0;  ///< whole periods that were taken off
};

/// A fitted curve: knots and the slope at each as a combination of the columns. A periodic curve is a natural spline
/// over enough periods to either side that its ends have no effect, so every period is a copy of the next. Immutable.
class Curve {
 public:
  /// times: J >= 2, strictly increasing. Errors: InvalidOption (period too short, tensions or biases of another count,
  /// a bias outside [-1, 1], speeds or numbers that are not finite), TimesNotIncreasing, TimeCountMismatch.
  static Result<Curve> fit(const std::vector<double>& times, const CurveOptions& options);

  /// Weights of the value (derivative 0) or of its first or second derivative at time t. Outside the knots: linear from
  /// the end derivative. A periodic curve is only defined on one period: wrap() first.
  Weights weights(double t, int derivative = 0) const;

  /// The curve at time t, in the same form.
  CurvePoint at(double t) const;

  WrappedTime wrap(double t) const;

  /// From key to key, in the order of time: of an open curve all, of a periodic one those of its first period.
  std::vector<KeySpan> spans() const;

  /// The slope at time t as weights of the keys of all periods; those of end tangents are numbered as Columns has them.
  std::vector<KeyWeight> slopeAt(double t) const;

  /// First and last time: the key range, for a periodic curve one whole period.
  double start() const { return start_; }
  double end() const { return end_; }
  bool periodic() const { return periodic_; }
  /// Whether a period ends on the last key, which is the first one again, moved rigidly.
  bool closesOnLastKey() const { return periodic_ && !closes_; }

 private:
  // The keys in the order in which the curve comes to them.
  struct Knot {
    double time;
    int key, period;
    int step;  // that leads on from it
  };

  void placeKnots(const std::vector<double>& times, double period);
  Weights atKnots(double t, int derivative) const;  // over the knots, then the tangents
  Weights addUp(const Weights& atKnots) const;

  Columns columns_{0};
  double start_ = 0, end_ = 0;
  std::vector<Knot> knots_;
  Eigen::MatrixXd slope_;  // knots x (knots, start tangent, end tangent)
  bool linear_ = false, periodic_ = false, closes_ = false;
};

/// The period that a periodic curve gets where none is asked for: t_J - t_1 where the last key closes it, otherwise one
/// mean spacing more.
double defaultPeriod(const std::vector<double>& times, Closing closing);

}  // namespace shapespline
