// Foot sliding: displacement of vertices that should rest between two keys.
#pragma once

#include "core/hold/hold_system.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// The resting vertices depend only on the keys, so all methods are measured in the same way. Immutable.
class Sliding {
 public:
  /// keys: the natural cubic spline through the keys. mesh: must outlive this object.
  Sliding(const HoldMesh& mesh, const Curve& keys);

  /// Root mean square distance of the vertices of `shape`, the motion at t, from their rest positions, relative to the
  /// largest diagonal of a key. Vertices are weighted by area and rest. NaN if no vertex rests, and beyond the keys.
  /// shape: input vertices. weldedOf: welded vertex of each input vertex.
  double at(double t, const Positions& shape, const std::vector<int>& weldedOf) const;

 private:
  RestingSpline path_;
  std::vector<double> area_;
  double diagonal_;
};

}  // namespace shapespline
