// Conditions for a curve through keys: its ends, and numbers per key.
#pragma once

#include <optional>
#include <vector>

namespace shapespline {

/// Boundary condition at the ends of the curve.
enum class BoundaryKind { Natural, Hermite, Periodic };

/// Closing of a periodic curve.
enum class Closing {
  LastKey,  ///< the last key repeats the first, up to a rigid motion: the period is t_J - t_1
  Extra,    ///< the curve continues from the last key to the first in an additional interval
};

struct CurveOptions {
  bool linear = false;  ///< piecewise linear instead of cubic
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1, endSpeed = 1;
  bool startShape = false;  ///< hermite: the start tangent column replaces key 2 in the difference at key 1
  bool endShape = false;    ///< hermite: the end tangent column replaces key J - 1 in the difference at key J
  Closing closing = Closing::Extra;
  std::optional<double> period = {};
  // Empty, or J values.
  std::vector<double> tension = {};
  std::vector<double> bias = {};
  std::vector<double> earlier = {};  ///< of the interval after the key (interval_timing.h); no effect if linear
  std::vector<double> swing = {};    ///< of the interval after the key
};

}  // namespace shapespline
