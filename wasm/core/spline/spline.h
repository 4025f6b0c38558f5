// Cubic splines as weights: the curve at time t is an affine combination of the keys, with the same weights for every
// entry of a coordinate vector (paper Eq. 1-2 and 6; section 3.2).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/status.h"
#include "core/spline/curve_options.h"
#include "core/spline/interval_timing.h"
#include "core/spline/slope_rows.h"

namespace shapespline {

/// Columns of a weight vector for J keys: keys 0 to J - 1, then the shapes for end tangents.
struct Columns {
  int keys;
  int startTangent() const { return keys; }
  int endTangent() const { return keys + 1; }
  int count() const { return keys + 2; }
};

/// Steps between poses. Each has an increment for every rotation spline. Step s leads from key s to key s + 1. The
/// other steps have the numbers after those.
struct KeySteps {
  int keys;
  /// From the last key to the first, if a loop closes in an additional interval.
  int closing() const { return keys - 1; }
  /// From the second to last key to a copy of the first key, moved rigidly to the last key.
  int turnedClosing() const { return keys; }
  /// From the first key to the shape for the start tangent.
  int startTangent() const { return keys + 1; }
  /// From the last key to the shape for the end tangent.
  int endTangent() const { return keys + 2; }
  int count() const { return keys + 3; }
};

/// Cumulative weight of a step (Kim, Kim and Shin 1995): 0 before the step and 1 after it, except for the spline's
/// overshoot.
struct StepShare {
  int step;
  double share;
  int period;  ///< period of the step in a periodic curve, relative to the first period
};

/// Weight of a key of a periodic curve, separate for each period.
struct KeyWeight {
  int key, period;
  double weight;
};

/// The part of the curve between two neighbouring keys.
struct KeySpan {
  double start, end;
  int from, to;  ///< key indices
};

struct PartPoints;

/// A point of the curve: weights for linear quantities, and steps for rotations.
struct CurvePoint {
  Weights weights;
  int base = 0;                  ///< start key for products of increments: all earlier steps are complete
  int basePeriod = 0;            ///< period of the base key in a periodic curve
  std::vector<StepShare> steps;  ///< steps from the base on, in time order, without future steps
  /// For a periodic curve: `weights` before summation over the periods; otherwise empty.
  std::vector<KeyWeight> unrolled;
  bool closes = false;  ///< whether the closing step is part of the curve
  int beyond = -1;      ///< end key from which the curve continues beyond the keys, or -1 within them
  /// The points of parts with timings of their own; null if none differs.
  std::shared_ptr<const PartPoints> parts = {};

  /// The point for the mean position of the shape.
  const CurvePoint& position() const;

  CurvePoint();
  CurvePoint(const CurvePoint& other);
  CurvePoint(CurvePoint&& other) noexcept;
  CurvePoint& operator=(const CurvePoint& other);
  CurvePoint& operator=(CurvePoint&& other) noexcept;
  ~CurvePoint();
};

/// Which part of a curve each patch of a shape follows.
struct PatchParts {
  std::vector<int> ofPatch;
  /// Patches whose rotation does not agree with their own path: they rotate with the mean of the parts.
  std::vector<char> rotatesWithMean;
};

struct PartPoints {
  CurvePoint position;
  std::vector<CurvePoint> ofPart;  ///< empty if all patches have the timing of the whole
  std::shared_ptr<const PatchParts> patches;
};

inline const CurvePoint& CurvePoint::position() const { return parts ? parts->position : *this; }

/// The point with the given weights: a blend of keys that may be off any curve.
CurvePoint blendedPoint(const Weights& weights, Columns columns);

/// A time mapped into one period.
struct WrappedTime {
  double time;
  int periods = 0;  ///< number of periods subtracted
};

/// A fitted curve: knots, and the slope at each as a combination of the columns. A periodic curve is a natural spline
/// over enough periods on either side that its ends have no effect, so all periods are equal. Immutable.
class Curve {
 public:
  /// times: J >= 2, strictly increasing. Errors: InvalidOption (period too short, wrong number of values per key, a
  /// bias outside [-1, 1], speeds or other numbers that are not finite), TimesNotIncreasing, TimeCountMismatch.
  static Result<Curve> fit(const std::vector<double>& times, const CurveOptions& options);

  /// Weights of the value (derivative 0) or of its first or second derivative at time t. Beyond the knots, the curve is
  /// linear with the end derivative. A periodic curve is defined on one period only: wrap() first.
  Weights weights(double t, int derivative = 0) const;

  /// The point of the curve at time t.
  CurvePoint at(double t) const { return pointAt(t, timing_); }
  bool isTimed() const { return timer_.has_value(); }  ///< whether any timing, also of a part, differs from 0
  int partCount() const { return static_cast<int>(parts_.size()); }
  /// The same with the timing of a part.
  CurvePoint partAt(double t, int part) const { return pointAt(t, parts_[part]); }

  WrappedTime wrap(double t) const;

  /// The curve with 0 for `earlier` and `swing`, without parts.
  Curve withoutTiming() const;

  /// Spans between keys in time order: all spans of an open curve, or those in the first period of a periodic curve.
  std::vector<KeySpan> spans() const;

  /// The slope at time t as weights of the keys of all periods. End tangents have their column numbers.
  std::vector<KeyWeight> slopeAt(double t) const;

  /// First and last time: the key range, or one period of a periodic curve.
  double start() const { return start_; }
  double end() const { return end_; }
  bool periodic() const { return periodic_; }
  /// Whether a period ends at the last key, a rigidly moved copy of the first key.
  bool closesOnLastKey() const { return periodic_ && !closes_; }

 private:
  // One passage of the curve through a key.
  struct Knot {
    double time;
    int key, period;
    int step;  // the following step
  };

  void placeKnots(const std::vector<double>& times, double period);
  // The values of the keys at the knots; 0 without values.
  Eigen::VectorXd ofKnots(const std::vector<double>& ofKeys) const;
  CurvePoint pointAt(double t, const IntervalTiming::Numbers& timing) const;
  // Over the knots, followed by the tangents.
  Weights atKnots(double t, int derivative, const IntervalTiming::Numbers& timing) const;
  IntervalTiming::Numbers ofIntervals(const KeyTiming& timing) const;
  Weights addUp(const Weights& atKnots) const;

  Columns columns_{0};
  double start_ = 0, end_ = 0;
  std::vector<Knot> knots_;
  KnotSpline spline_;
  std::optional<IntervalTiming> timer_;  // empty if no timing has an effect
  IntervalTiming::Numbers timing_;
  std::vector<IntervalTiming::Numbers> parts_;
  bool linear_ = false, periodic_ = false, closes_ = false;
};

/// Default period of a periodic curve: t_J - t_1 if the last key closes it, otherwise longer by the mean spacing.
double defaultPeriod(const std::vector<double>& times, Closing closing);

}  // namespace shapespline
