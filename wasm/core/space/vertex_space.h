// The space of vertex positions, for the baselines. It needs no encoding and no factor.
#pragma once

#include <span>

#include "core/mesh/vertex_normals.h"
#include "core/space/welded_keys.h"
#include "core/spline/pose_weights.h"

namespace shapespline {

/// weights: one per column.
void blendVertices(const WeldedShape& shape, std::span<const double> weights, Positions& blended);

/// The shape at `point`. In a loop that does not close in place, keys of other periods are turned.
/// meanPosition: of each key.
void blendVertices(const WeldedShape& shape, const std::vector<Vec3>& meanPosition, const CurvePoint& point,
                   Positions& blended);

/// Immutable.
class VertexSpace {
 public:
  /// keys: must outlive the space.
  explicit VertexSpace(const WeldedKeys& keys);

  /// Draws positions in the order of the welded vertices.
  const VertexNormals& normals() const { return normals_; }

  /// The shape at `point`.
  void positions(const CurvePoint& point, Positions& positions) const;

 private:
  const WeldedKeys* keys_;
  VertexNormals normals_;
};

}  // namespace shapespline
