// Patches that rest between two keys, and the constant low-rank correction that keeps their mean positions in place.
#pragma once

#include <vector>

#include "core/hold/hold_system.h"
#include "core/hold/resting_spline.h"

namespace shapespline {

/// Handles on the patches that rest in some span. Immutable.
class ContactConstraints {
 public:
  /// patchOf: of each vertex, or -1. area: of each vertex.
  ContactConstraints(const RestingSpline& path, const HoldSystem& system, const std::vector<int>& patchOf, int patches,
                     const std::vector<double>& area);

  /// The mean displacements of the vertices of each handle.
  void meanDisplacements(const Positions& from, const Positions& to, std::vector<Vec3>& displacement) const;

  /// How much each handle holds at a time, in [0, 1]; false where none does.
  bool weightsAt(const SpanPosition& inSpan, std::vector<double>& weight) const;

  /// What the vertices of each handle are pulled by, so they move by about what is left of their way. Replaces `left`.
  void pull(std::vector<Vec3>& left) const;

  /// Adds the handles' pulls to those of their vertices.
  void addTo(Positions& pulls, const std::vector<Vec3>& pull) const;

  /// What each handle's pull moves every vertex by, a row per vertex (hold_passes.h); empty where that is no less work
  /// than to solve.
  const std::vector<float>& response() const { return response_; }

 private:
  // What a handle holds of a vertex.
  struct Share {
    int vertex, handle;
    double share;
  };
  void findCompliance(const HoldSystem& system, std::size_t vertices);

  std::vector<Share> shares_;
  bool loop_;
  int spans_;
  std::vector<double> rest_;  // of each handle in each span
  int count_ = 0;
  std::vector<float> response_;
  std::vector<double> factor_;  // lower Cholesky factor of (handles' compliance + a tenth of its mean), by rows
};

}  // namespace shapespline
