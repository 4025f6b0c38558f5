// The way of a pin that was dragged: a cubic spline through its keys that stands still beyond them.
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
  /// along: the curve of the motion. In a loop the path is one, too; its keys outside the first period are left out.
  /// closing: what a period that ends elsewhere is moved by. Null where no key is left. Error: that of the curve.
  static Result<std::unique_ptr<const PinPath>> create(const std::vector<PathKey>& keys, const Curve& along,
                                                       const std::optional<RigidMotion>& closing);

  /// What the pin is moved by at t, within the first period of a loop.
  Vec3 at(double t) const;

 private:
  PinPath(const std::vector<PathKey>& keys, const Curve& along, const std::optional<RigidMotion>& closing);
  Status fit(const std::vector<double>& times, const Curve& along);
  Mat3 turned(double t) const;

  double start_, period_;
  std::optional<RigidMotion> closing_;
  WeldedShape keys_;  // of one vertex; in a loop as it was before it turned
  std::optional<Curve> curve_;
  std::optional<RestingSpline> path_;
};

}  // namespace shapespline
