// The facade: keyframes and options in, the shape at any time out.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/hold/sliding.h"
#include "core/sequence/feature_curve.h"
#include "core/sequence/motion.h"
#include "core/sequence/shared_shape.h"

namespace shapespline {

/// A motion of a shape, evaluated at any time. evaluate is a pure function of keys, options and t, bit for bit. Not
/// thread-safe, nor are several of one shape.
class Sequence {
 public:
  /// A motion of a shape that may have others. before: one of them, which what is costly is taken from; or null.
  /// progress, order: as for SharedShape::makeSpace. Errors: those of SharedShape::makeSpace and of Motion::fit.
  static Result<Sequence> fit(std::shared_ptr<SharedShape> shape, std::vector<double> keyTimes,
                              const MotionOptions& motion, const Sequence* before = nullptr,
                              const StageProgress& progress = {}, OrderSource order = nullptr);

  /// The same of a shape of its own. progress: of each in turn. Errors: those of SharedShape::encode as well.
  static Result<Sequence> create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                 const StageProgress& progress = {}, OrderSource order = nullptr);

  /// Another motion through the same keys. Errors: those of Motion::fit; the old motion stays then.
  Status update(const MotionOptions& motion, const std::vector<double>& keyTimes);

  /// The shape at time t, which may lie beyond the keys.
  Status evaluate(double t, Frame& frame);

  /// Frames are made by two from here on, to the same bits, or by one with null. It must outlive the sequence.
  void setForkJoin(ForkJoin* forkJoin) { shape_->evaluator().setForkJoin(forkJoin); }

  /// The same as n positions without rounding them to float: for measures and tests. As exact as the encoding's
  /// precision.
  Status evaluate(double t, Positions& positions);

  /// How far what rests between its keys is from its place in `shape`, which is evaluate(t) (hold/sliding.h); NaN where
  /// nothing rests, and where the shape moves on with a loop or is kept in place.
  /// Error: those of SharedShape::makeSpace.
  Result<double> sliding(double t, const Positions& shape);

  /// The shape at an affine combination of the keys: one weight per key, sum 1. evaluate(t) is this at the curve's
  /// weights, but for what the motion holds.
  Status evaluateBlend(const std::vector<double>& weights, Frame& frame);

  /// The ghost that belongs to the shape at time t: xyz of each ghost vertex. Errors: InvalidOption without a ghost,
  /// and those of SharedShape::makeSpace.
  Status evaluateGhost(double t, std::vector<float>& positions);

  const EncodedShape& encoded() const { return shape_->encoded(); }
  const Motion& motion() const { return motion_; }
  /// Of the input.
  const std::vector<Triangle>& faces() const { return encoded().input().faces; }
  SequenceStats stats() const { return shape_->stats(); }
  /// Of the shape and the motion, and where its times carry it far from its keys (uneven_times.h).
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// First and last time at which the curve is defined by keys (for periodic: one whole period).
  std::pair<double, double> range() const { return motion_.range(); }

  /// The rotations G_k of the patches (of the ghost, with one) at time t, as the first system gives them and the whole
  /// is turned.
  Status patchRotations(double t, std::vector<Quaternion>& rotations);

  /// What can be said of it in LRI space, which is made for it where it is not there. Errors: those of
  /// SharedShape::makeSpace.
  Result<FeatureCurve> featureCurve();

 private:
  Sequence(std::shared_ptr<SharedShape> shape, Motion motion) : shape_(std::move(shape)), motion_(std::move(motion)) {}
  void collectWarnings();

  std::shared_ptr<SharedShape> shape_;
  Motion motion_;
  std::vector<Warning> warnings_;
  std::unique_ptr<const Sliding> sliding_;  // of the motion's key times, made when it is first asked for
};

}  // namespace shapespline
