// Patches that rest between two keys, and the constant low-rank correction that keeps their mean positions in place.
#pragma once

#include <vector>

#include "core/hold/hold_system.h"
#include "core/hold/vertex_path.h"

namespace shapespline {

/// Handles on the patches that rest in some span. Immutable.
class RestingPatches {
 public:
  /// patchOf: of each vertex, or -1. area: of each vertex.
  RestingPatches(const VertexPath& path, const HoldSystem& system, const std::vector<int>& patchOf, int patches,
                 const std::vector<double>& area);

  int count() const { return count_; }
  /// Of each vertex, or -1, and the vertex's share in the handle.
  const std::vector<int>& handleOf() const { return handleOf_; }
  const std::vector<double>& share() const { return share_; }

  /// How much each handle holds at a place, in [0, 1]; false where none does.
  bool weightsAt(const SpanPlace& place, std::vector<double>& weight) const;

  /// What the vertices of each handle are pulled by, so that they move by about what is left of their way. Replaces
  /// `left`.
  void pull(std::vector<Vec3>& left) const;

 private:
  void findCompliance(const HoldSystem& system);

  std::vector<int> handleOf_;
  std::vector<double> share_;
  bool loop_;
  int spans_;
  std::vector<double> rest_;  // of each handle in each span
  int count_ = 0;
  std::vector<double> factor_;  // lower Cholesky factor of (handles' compliance + a tenth of its mean), by rows
};

}  // namespace shapespline
