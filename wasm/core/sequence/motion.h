// A motion through the keys of an encoded shape. Maps time to curve points. Created in microseconds, except for holding
// and pins.
#pragma once

#include <memory>
#include <numbers>
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

/// Patches whose rotation differs more from their own path, in radians, would jump along it.
inline constexpr double pathsAgree = std::numbers::pi / 3;

/// The curve through the keys at their times, the added turns, and the motion of the whole. Immutable.
class Motion {
 public:
  /// encoded: the method's space must exist. before: another motion of the same shape whose costly parts are reused, or
  /// null. Errors: InvalidOption, NotFinite, TimesNotIncreasing, TimeCountMismatch, and those of the solver.
  static Result<Motion> fit(const EncodedShape& encoded, std::vector<double> keyTimes, const MotionOptions& options,
                            const Motion* before = nullptr);

  const MotionOptions& options() const { return options_; }
  const std::vector<double>& keyTimes() const { return times_; }
  /// With regions, the curve with the mean of their timings.
  const Curve& curve() const { return curve_; }
  /// The curve without values per key. shape: the shape of this motion.
  Curve unshapedCurve(const WeldedShape& shape) const;
  /// The same curve, with parts of these timings.
  Curve curveWithParts(const WeldedShape& shape, std::vector<KeyTiming> parts) const;
  /// The natural cubic spline through the same keys at the same times.
  Curve naturalCurve() const;
  const PatchTurns& turns() const { return turns_; }

  /// First and last time of the keys; for a periodic motion, one period.
  std::pair<double, double> range() const { return {curve_.start(), curve_.end()}; }

  /// The point of the curve at any time.
  CurvePoint at(double t) const;

  /// The rigid motion to apply to the reconstructed shape at `t`. point: at(t).
  RigidMotion globalMotion(const EncodedShape& encoded, double t, const CurvePoint& point) const;

  bool inLri() const { return !blendsVertices() && !turnsFaces(options_.method); }
  bool blendsVertices() const { return shapespline::blendsVertices(options_.method); }

  /// Corrections of the shapes, or null.
  const HeldMotion* held() const { return held_.get(); }
  const PinnedMotion* pinned() const { return pinned_.get(); }
  bool corrects() const { return held_ || pinned_; }
  /// Mean vertex position in a loop that does not close in place, relative to the mean of the blended keys.
  Vec3 loopMove(const EncodedShape& encoded, const CurvePoint& point) const;

  /// Warnings of the encoded shape and the space, and about ambiguities of this motion's keys.
  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  Motion(Curve curve, std::vector<double> times, const MotionOptions& options)
      : curve_(std::move(curve)), times_(std::move(times)), options_(options) {}
  Status hold(const EncodedShape& encoded, const Motion* before);
  void findRotationsOfParts(const PatchMotion& patches);
  void collectWarnings(const EncodedShape& encoded);
  void warnOfTurnedLoop(const WeldedShape& shape);
  void warnOfTurnsNotHeld();
  std::vector<Warning> patchWarnings(const EncodedShape& encoded) const;

  Curve curve_;
  std::vector<double> times_;
  MotionOptions options_;
  PatchTurns turns_;
  std::shared_ptr<PatchParts> parts_;  // null without regions
  std::shared_ptr<const HeldMotion> held_;
  std::shared_ptr<const PinnedMotion> pinned_;
  std::vector<Warning> warnings_;
};

}  // namespace shapespline
