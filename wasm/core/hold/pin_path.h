// The offset of a dragged pin over time: a cubic spline through its keys, constant beyond them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/hold/pin.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// Immutable.
class PinPath {
 public:
  /// along: the curve of the motion. In a loop, the path is periodic too, and keys outside the first period are
  /// dropped. closing: rigid motion per period of a loop that does not close in place. The result is null without keys.
  /// Error: the curve's.
  static Result<std::unique_ptr<const PinPath>> create(const std::vector<PathKey>& keys, const Curve& along,
                                                       const std::optional<RigidMotion>& closing);

  /// Offset of the pin at t, within the first period of a loop.
  Vec3 at(double t) const;

 private:
  PinPath(const std::vector<PathKey>& keys, const Curve& along, const std::optional<RigidMotion>& closing);
  Status fit(const std::vector<double>& times, const Curve& along);
  Mat3 turned(double t) const;

  double start_, period_;
  std::optional<RigidMotion> closing_;
  WeldedShape keys_;  // keys of one vertex; in a loop, before the rotation by turned()
  std::optional<Curve> curve_;
  std::optional<RestingSpline> path_;
};

}  // namespace shapespline
