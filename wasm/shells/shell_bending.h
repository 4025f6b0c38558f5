// How strongly a motion bends, by the lengths and angles of a mesh: one measure for motions of any method.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/mesh/weld.h"
#include "shells/shell_metric.h"

namespace shapespline {

/// The squared second derivative of lengths and angles over time, relative to the mean squared change between keys.
/// Rigid motions of a shape have no effect. Immutable.
class ShellBending {
 public:
  /// faces, keys: of a mesh, at least one key; copies of a vertex that coincide in all keys are one. Error: NoArea.
  static Result<ShellBending> create(const std::vector<Triangle>& faces, const std::vector<Positions>& keys);

  /// Lengths and angles of a shape, on the vertices of the keys.
  ShellMeasures measuresOf(const Positions& shape) const;

  /// |z''|^2 / mean |z_j - z_(j-1)|^2 by second differences of three shapes `step` apart in time; 0 if the keys are
  /// equal, NaN where an edge has no length. Angles change the shorter way round.
  double energy(const ShellMeasures& before, const ShellMeasures& here, const ShellMeasures& after, double step) const;

 private:
  ShellBending(Welding welding, ShellMetric metric) : welding_(std::move(welding)), metric_(std::move(metric)) {}

  Welding welding_;
  ShellMetric metric_;
  double average_ = 0;  // of the squared changes between keys
};

}  // namespace shapespline
