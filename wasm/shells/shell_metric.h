// The measures of a shell, its edge lengths and dihedral angles, and their weights.
#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// An edge of the mesh. left, right: third corners of its two faces; the left face runs along the edge from `from` to
/// `to`, the right one from `to` to `from`. -1 if the edge has no dihedral angle.
struct ShellEdge {
  int from, to;
  int left = -1, right = -1;
};

/// Lengths of all edges, then the angles of those that have one.
using ShellMeasures = std::vector<double>;

/// A constant metric of lengths and angles, for thin shells of one material (Grinspun et al. 2003, Froehlich and Botsch
/// 2011). Immutable.
class ShellMetric {
 public:
  /// The derivative of a measure: its vertices, and its gradient with respect to each.
  struct Row {
    std::array<int, 4> vertex;
    std::array<Vec3, 4> gradient;
    int count;
  };

  /// faces: a welded mesh. poses: the keys; the first key determines the weights. Some edges have no angle: those with
  /// one face or more than two, those whose faces are wound in opposite directions, and those of a face that has no
  /// area in some pose.
  ShellMetric(const std::vector<Triangle>& faces, const std::vector<Positions>& poses);

  int vertexCount() const { return vertices_; }
  int edgeCount() const { return static_cast<int>(edges_.size()); }
  int angleCount() const { return angles_; }
  int measureCount() const { return edgeCount() + angles_; }
  /// Those with an angle come first.
  const std::vector<ShellEdge>& edges() const { return edges_; }
  const std::vector<double>& weights() const { return weight_; }

  ShellMeasures measuresOf(const Positions& positions) const;

  /// The measures of each key. Angles are on the branch closest to the angle in the previous key.
  std::vector<ShellMeasures> measuresOfKeys(const std::vector<Positions>& keys) const;

  /// a - b; differences of angles are wrapped to [-pi, pi].
  ShellMeasures difference(const ShellMeasures& a, const ShellMeasures& b) const;

  /// The square of the length of a difference.
  double squaredNorm(const ShellMeasures& difference) const;

  /// The derivative of one measure.
  Row rowOf(int measure, const Positions& positions) const;

  /// The first-order change of the measures if the vertices move by `change`.
  ShellMeasures changeOf(const Positions& positions, const Positions& change) const;

 private:
  int vertices_ = 0, angles_ = 0;
  std::vector<ShellEdge> edges_;
  std::vector<double> weight_;
};

}  // namespace shapespline
