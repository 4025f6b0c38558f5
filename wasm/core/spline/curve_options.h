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

/// When the curve passes each interval, and how far it swings out (interval_timing.h). No effect if linear.
struct KeyTiming {
  std::vector<double> earlier, swing;  ///< empty, or J values: of the interval after the key
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
  KeyTiming timing = {};
  std::vector<KeyTiming> parts = {};  ///< the curve again for parts of a shape, with timings of their own
};

}  // namespace shapespline
