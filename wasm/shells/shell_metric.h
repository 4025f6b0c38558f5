// What a shell measures of itself: the lengths of its edges and the dihedral angles at them, and how much each counts.
#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// An edge of the mesh. left, right: the third corners of the faces beside it, of that which runs along it from `from`
/// to `to` and of that which runs against it; -1 where the edge has no dihedral angle.
struct ShellEdge {
  int from, to;
  int left = -1, right = -1;
};

/// Lengths of all edges, then the angles of those that have one.
using ShellMeasures = std::vector<double>;

/// A constant metric of lengths and angles: of shells that are thin and made of one material (Grinspun et al. 2003,
/// Froehlich and Botsch 2011). Immutable.
class ShellMetric {
 public:
  /// What a measure depends on: its vertices, its gradient by each, and its weight.
  struct Row {
    std::array<int, 4> vertex;
    std::array<Vec3, 4> gradient;
    int count;
  };

  /// faces: of a welded mesh. poses: the keys; the first one weighs. Edges with one face or more than two, with faces
  /// that run along them the same way, and beside faces without area in some pose have a length only.
  ShellMetric(const std::vector<Triangle>& faces, const std::vector<Positions>& poses);

  int vertexCount() const { return vertices_; }
  int edgeCount() const { return static_cast<int>(edges_.size()); }
  int angleCount() const { return angles_; }
  int measureCount() const { return edgeCount() + angles_; }
  /// Those with an angle come first.
  const std::vector<ShellEdge>& edges() const { return edges_; }
  const std::vector<double>& weights() const { return weight_; }

  ShellMeasures measuresOf(const Positions& positions) const;

  /// The measures of some keys, their angles on the branches nearest to those of the key before.
  std::vector<ShellMeasures> measuresOfKeys(const std::vector<Positions>& keys) const;

  /// a - b, of angles the way round that is shorter.
  ShellMeasures difference(const ShellMeasures& a, const ShellMeasures& b) const;

  /// The square of the length of a difference.
  double squaredNorm(const ShellMeasures& difference) const;

  /// The derivative of one measure.
  Row rowOf(int measure, const Positions& positions) const;

  /// How the measures change where the vertices move by `change`, to first order.
  ShellMeasures changeOf(const Positions& positions, const Positions& change) const;

 private:
  int vertices_ = 0, angles_ = 0;
  std::vector<ShellEdge> edges_;
  std::vector<double> weight_;
};

}  // namespace shapespline
