// Patches at rest between two keys, and the constant low-rank correction that keeps their mean positions.
#pragma once

#include <vector>

#include "core/hold/hold_system.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// Handles on the patches that rest in some span. Immutable.
class ContactConstraints {
 public:
  /// patchOf: patch of each vertex, or -1. area: area of each vertex.
  ContactConstraints(const RestingSpline& path, const HoldSystem& system, const std::vector<int>& patchOf, int patches,
                     const std::vector<double>& area);

  /// The mean displacement of each handle's vertices.
  void meanDisplacements(const Positions& from, const Positions& to, std::vector<Vec3>& displacement) const;

  /// Weight of each handle in a span, in [0, 1]; false if all weights are 0.
  bool weightsAt(const SpanPosition& inSpan, std::vector<double>& weight) const;

  /// Replaces the remaining displacements `left` by the pulls on each handle's vertices that approximately produce
  /// them.
  void pull(std::vector<Vec3>& left) const;

  /// Adds the pulls of the handles to those of their vertices.
  void addTo(Positions& pulls, const std::vector<Vec3>& pull) const;

  /// Displacement of every vertex per pull at each handle, one row per vertex (hold_passes.h). Empty if a solve is
  /// cheaper.
  const std::vector<float>& response() const { return response_; }

 private:
  // Share of a vertex in a handle.
  struct Share {
    int vertex, handle;
    double share;
  };
  void findCompliance(const HoldSystem& system, std::size_t vertices);

  std::vector<Share> shares_;
  bool loop_;
  int spans_;
  std::vector<double> rest_;  // rest of each handle in each span
  int count_ = 0;
  std::vector<float> response_;
  std::vector<double> factor_;  // lower Cholesky factor of (compliance of the handles + a tenth of its mean), by rows
};

}  // namespace shapespline
