// How far what should rest between two keys goes from its place.
#pragma once

#include "core/hold/hold_system.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// The keys alone decide which vertices rest, so all methods are measured alike. Immutable.
class Sliding {
 public:
  /// keys: the natural cubic spline through them. mesh: must outlive it.
  Sliding(const HoldMesh& mesh, const Curve& keys);

  /// Root of the mean square distance of the vertices of `shape`, the motion at t, from where they rest, over the
  /// largest diagonal of a key; each counts by its area and how much it rests. NaN where nothing rests, and beyond the
  /// keys. shape: of the input; weldedOf: of its vertices.
  double at(double t, const Positions& shape, const std::vector<int>& weldedOf) const;

 private:
  RestingSpline path_;
  std::vector<double> area_;
  double diagonal_;
};

}  // namespace shapespline
