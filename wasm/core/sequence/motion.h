// A motion through an encoded shape's keys: what time means. Made in microseconds, but for what it holds.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/warning.h"
#include "core/hold/pinned_motion.h"
#include "core/rotation/rigid_motion.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/options.h"
#include "core/spline/spline.h"

namespace shapespline {

/// The curve through the keys at their times, what turns are added, and how the whole is moved along. Immutable.
class Motion {
 public:
  /// encoded: the space that the method needs must have been made. Errors: InvalidOption, NotFinite,
  /// TimesNotIncreasing, TimeCountMismatch, and those of the solver. before: another motion of the same shape, which
  /// what is costly is taken from; or null.
  static Result<Motion> fit(const EncodedShape& encoded, std::vector<double> keyTimes, const MotionOptions& options,
                            const Motion* before = nullptr);

  const MotionOptions& options() const { return options_; }
  const std::vector<double>& keyTimes() const { return times_; }
  const Curve& curve() const { return curve_; }
  /// The curve as it would be without tensions and biases. shape: of what this motion was fitted to.
  Curve unshapedCurve(const WeldedShape& shape) const;
  /// The natural cubic spline through the same keys at the same times.
  Curve naturalCurve() const;
  const PatchTurns& turns() const { return turns_; }

  /// First and last time at which the curve is defined by keys (for periodic: one whole period).
  std::pair<double, double> range() const { return {curve_.start(), curve_.end()}; }

  /// The point of the curve at any time.
  CurvePoint at(double t) const { return curve_.at(curve_.wrap(t).time); }

  /// What the shape at `t` is moved by after its reconstruction; point: at(t).
  RigidMotion globalMotion(const EncodedShape& encoded, double t, const CurvePoint& point) const;

  bool inLri() const { return !blendsVertices() && !turnsFaces(options_.method); }
  bool blendsVertices() const { return shapespline::blendsVertices(options_.method); }

  /// What shapes are corrected by, or null.
  const HeldMotion* held() const { return held_.get(); }
  const PinnedMotion* pinned() const { return pinned_.get(); }
  bool corrects() const { return held_ || pinned_; }
  /// Where the mean of a loop's vertices is that ends elsewhere, against the mean of its keys' blend.
  Vec3 loopMove(const EncodedShape& encoded, const CurvePoint& point) const;

  /// Those of the encoded shape and of the space, and what this motion's keys leave open.
  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  Motion(Curve curve, std::vector<double> times, const MotionOptions& options)
      : curve_(std::move(curve)), times_(std::move(times)), options_(options) {}
  Status hold(const EncodedShape& encoded, const Motion* before);
  void collectWarnings(const EncodedShape& encoded);
  std::vector<Warning> patchWarnings(const EncodedShape& encoded) const;

  Curve curve_;
  std::vector<double> times_;
  MotionOptions options_;
  PatchTurns turns_;
  std::shared_ptr<const HeldMotion> held_;
  std::shared_ptr<const PinnedMotion> pinned_;
  std::vector<Warning> warnings_;
};

}  // namespace shapespline
