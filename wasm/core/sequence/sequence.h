// The facade: keyframes and options in, the shape at any time out.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/hold/sliding.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/evaluator.h"
#include "core/sequence/feature_curve.h"
#include "core/sequence/motion.h"

namespace shapespline {

/// A completed motion. Built once (weld, encode, factorise), then evaluated at any time; evaluate is a pure function of
/// keys, options and t, bit for bit. Not thread-safe.
class Sequence {
 public:
  /// keyframes: moved in where the caller needs them no more; freed once they are welded. progress: called with a
  /// stage's name and the fraction of the whole work that is done, in [0, 1] and never falling. order: as for
  /// EncodedShape::build.
  /// Errors: those of EncodedShape::build and of Motion::fit.
  static Result<Sequence> create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                 const StageProgress& progress = {}, OrderSource order = nullptr);

  /// Another motion through the same keys. Errors: those of Motion::fit; the old motion stays then.
  Status update(const MotionOptions& motion, const std::vector<double>& keyTimes);

  /// The shape at time t, which may lie beyond the keys.
  Status evaluate(double t, Frame& frame);

  /// Frames are made by two from here on, to the same bits, or by one with null. It must outlive the sequence.
  void setForkJoin(ForkJoin* forkJoin) { evaluator_.setForkJoin(forkJoin); }

  /// The same as n positions without rounding them to float: for measures and tests. As exact as the encoding's
  /// precision.
  Status evaluate(double t, Positions& positions);

  /// How far what rests between its keys is from its place in `shape`, which is evaluate(t) (hold/sliding.h); NaN where
  /// nothing rests, and where the shape moves on with a loop or is kept in place.
  double sliding(double t, const Positions& shape);

  /// The shape at an affine combination of the keys: one weight per key, sum 1. evaluate(t) is this at the curve's
  /// weights, but for what the motion holds.
  Status evaluateBlend(const std::vector<double>& weights, Frame& frame);

  /// The ghost that belongs to the shape at time t: xyz of each ghost vertex. Error: InvalidOption without a ghost.
  Status evaluateGhost(double t, std::vector<float>& positions);
  const Ghost& ghost() const { return encoded_.ghost(); }

  const EncodedShape& encoded() const { return encoded_; }
  const Motion& motion() const { return motion_; }
  /// Of the input.
  const std::vector<Triangle>& faces() const { return encoded_.input().faces; }
  SequenceStats stats() const { return {encoded_.stats(), evaluator_.stats()}; }
  /// Of the shape and the motion, and where its times carry it far from its keys (uneven_times.h).
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// First and last time at which the curve is defined by keys (for periodic: one whole period).
  std::pair<double, double> range() const { return motion_.range(); }

  /// Patch of each face of the input, in [0, stats().patches); -1 for faces without area.
  const std::vector<int>& patchOfFace() const { return encoded_.patchOfInputFace(); }

  /// Component of each face of the input, in [0, stats().components), numbered by their first faces; -1 for faces
  /// without area.
  const std::vector<int>& componentOfFace() const { return encoded_.componentOfInputFace(); }

  /// The rotations G_k of the patches (of the ghost, with one) at time t, as the first system gives them and the whole
  /// is turned.
  Status patchRotations(double t, std::vector<Quaternion>& rotations);

  /// feature_curve.h
  ShapePlane shapePlane(const std::vector<double>& times) { return featureCurve().plane(times); }
  Result<DiscretePath> discretePath(int samples) { return featureCurve().discretePath(samples); }
  /// inputFace: in [0, faces().size()). Error: InvalidOption.
  Result<PartCurve> faceCurve(int inputFace, const std::vector<double>& times);
  /// patch: one of patchOfFace(). Error: InvalidOption.
  Result<PartCurve> patchCurve(int patch, const std::vector<double>& times);
  KeyPace keyPace() { return featureCurve().pace(); }
  MotionPace motionPace(const std::vector<double>& times) { return featureCurve().paceAt(times); }
  std::vector<double> bendingEnergy(const std::vector<double>& times) { return featureCurve().bendingEnergy(times); }

 private:
  Sequence(EncodedShape encoded, Motion motion) : encoded_(std::move(encoded)), motion_(std::move(motion)) {}
  void collectWarnings();
  FeatureCurve featureCurve();

  EncodedShape encoded_;
  Motion motion_;
  Evaluator evaluator_;
  std::vector<Warning> warnings_;
  // Made when they are first asked for.
  Eigen::MatrixXd gram_;
  std::unique_ptr<const Sliding> sliding_;  // of the motion's key times
};

}  // namespace shapespline
