// Computes shapes of a motion through keys by fitting them to splined lengths and angles.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "shells/shell_system.h"

namespace shapespline {

/// A time at which to compute the shape.
struct ShellSample {
  double time = 0;
  std::vector<double> weights;  ///< the spline's weights of the keys at this time, sum 1
  Positions start;              ///< LRI's shape at this time: the start of the fit, and the position of its components
  int key = -1;                 ///< the key at this time, which is then the result, or -1
};

/// How the shapes between the keys are computed.
enum class ShellMethod {
  Lengths,  ///< fitted to splined lengths and angles
  Spline,   ///< as Lengths, then improved to the time-discrete spline in the space of shells
};

struct ShellShapes {
  std::vector<Positions> shapes;  ///< one per sample
  std::vector<int> failed;        ///< intervals without a fit at some sample, by their last key; they keep their starts
  /// intervals where Spline could not lower the bending energy, by their last key; their shapes are those of Lengths
  std::vector<int> stiff;
  bool finished = true;  ///< false if the search for the least bending energy ended early; it could be lower
  int factors = 0;
};

/// keys: poses of one mesh; vertices that coincide in all keys are merged. samples: in increasing time, starting with
/// the first key and ending with the last. Errors: those of the solver, and NoArea.
Result<ShellShapes> shellShapes(const std::vector<Triangle>& faces, const std::vector<Positions>& keys,
                                const std::vector<ShellSample>& samples, ShellMethod method,
                                const FractionReport& onProgress = {});

}  // namespace shapespline
