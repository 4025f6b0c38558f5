// The facade: evaluates shapes at any time from keyframes and options.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/hold/sliding.h"
#include "core/sequence/feature_curve.h"
#include "core/sequence/motion.h"
#include "core/sequence/shared_shape.h"
#include "core/sequence/timing_derivatives.h"

namespace shapespline {

/// A motion of a shape, evaluated at any time. evaluate is a pure function of keys, options and t, bit for bit. Not
/// thread-safe, even between motions of one shape.
class Sequence {
 public:
  /// Creates a motion of a shape, which may have others. before: another motion of the shape whose costly parts are
  /// reused, or null. progress, order: as for SharedShape::makeSpace. Errors: those of SharedShape::makeSpace and of
  /// Motion::fit.
  static Result<Sequence> fit(std::shared_ptr<SharedShape> shape, std::vector<double> keyTimes,
                              const MotionOptions& motion, const Sequence* before = nullptr,
                              const StageProgress& progress = {}, OrderSource order = nullptr);

  /// Creates a motion with a new shape. progress: reports both steps. Errors: as above, and those of
  /// SharedShape::encode.
  static Result<Sequence> create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                 const StageProgress& progress = {}, OrderSource order = nullptr);

  /// Changes the motion through the same keys. On errors, those of Motion::fit, the old motion stays.
  Status update(const MotionOptions& motion, const std::vector<double>& keyTimes);

  /// The shape at time t, including times beyond the keys. Errors: InvalidOption for a time that is not finite;
  /// NotFinite if the shape exceeds the range of numbers.
  Status evaluate(double t, Frame& frame);

  /// Computes frames on two threads, or on one if forkJoin is null. Results are bitwise equal. forkJoin must outlive
  /// the sequence.
  void setForkJoin(ForkJoin* forkJoin) { shape_->evaluator().setForkJoin(forkJoin); }

  /// The shape as n positions without rounding to float, for measures and tests. The accuracy depends on the encoding's
  /// precision.
  Status evaluate(double t, Positions& positions);

  /// Displacement of resting vertices in `shape`, which is evaluate(t) (hold/sliding.h). NaN if no vertex rests, or if
  /// the shape moves on with a loop or is kept in place.
  /// Error: those of SharedShape::makeSpace.
  Result<double> sliding(double t, const Positions& shape);

  /// The shape at an affine combination of the keys: one weight per key, sum 1. With the curve's weights at t, equals
  /// evaluate(t) without holding.
  Status evaluateBlend(const std::vector<double>& weights, Frame& frame);

  /// The ghost at time t: xyz of each ghost vertex. Errors: InvalidOption without a ghost, and those of
  /// SharedShape::makeSpace.
  Status evaluateGhost(double t, std::vector<float>& positions);

  const EncodedShape& encoded() const { return shape_->encoded(); }
  const Motion& motion() const { return motion_; }
  /// The faces of the input.
  const std::vector<Triangle>& faces() const { return encoded().input().faces; }
  SequenceStats stats() const { return shape_->stats(); }
  /// Warnings of the shape and the motion, and about times that carry the motion far from its keys (uneven_times.h).
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// First and last time of the keys; for a periodic motion, one period.
  std::pair<double, double> range() const { return motion_.range(); }

  /// The rotations G_k of the patches (of the ghost's, if any) at time t, after rotating the whole.
  Status patchRotations(double t, std::vector<Quaternion>& rotations);

  /// timing_derivatives.h. Errors: those of SharedShape::makeSpace, too.
  Result<TimingDerivatives> timingDerivatives(double t, const std::vector<int>& regionOf);

  /// The motion's curve in LRI space, which is built if needed. Errors: those of SharedShape::makeSpace.
  Result<FeatureCurve> featureCurve();

 private:
  Sequence(std::shared_ptr<SharedShape> shape, Motion motion) : shape_(std::move(shape)), motion_(std::move(motion)) {}
  void collectWarnings();

  std::shared_ptr<SharedShape> shape_;
  Motion motion_;
  std::vector<Warning> warnings_;
  std::unique_ptr<const Sliding> sliding_;  // for the motion's key times, created on first use
};

}  // namespace shapespline
