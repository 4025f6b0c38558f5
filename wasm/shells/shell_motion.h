// The shapes at some times of a motion through keys: fitted to splined lengths and angles.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "shells/shell_system.h"

namespace shapespline {

/// A time of the motion, whose shape is wanted.
struct ShellSample {
  double time = 0;
  std::vector<double> weights;  ///< one per key, sum 1: of the spline at this time
  Positions start;              ///< the shape that LRI space has there: where the fit starts, and the shape's place
  int key = -1;                 ///< key at this time, which the sample is then, or -1
};

/// What the shapes between the keys are.
enum class ShellMethod {
  Lengths,  ///< those whose lengths and angles come nearest to splined ones
  Spline,   ///< from there on, the time-discrete spline in the space of shells
};

struct ShellShapes {
  std::vector<Positions> shapes;  ///< one per sample
  std::vector<int> failed;        ///< keys that end the intervals whose fits did not converge: their starts are kept
  int factors = 0;
};

/// keys: of one mesh; copies of a vertex that coincide in all of them are one. samples: in the order of time, from the
/// first key to the last, which are samples. Errors: those of the solver, and NoArea.
Result<ShellShapes> shellShapes(const std::vector<Triangle>& faces, const std::vector<Positions>& keys,
                                const std::vector<ShellSample>& samples, ShellMethod method,
                                const FractionReport& onProgress = {});

}  // namespace shapespline
