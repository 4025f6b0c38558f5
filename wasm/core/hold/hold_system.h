// How a shape gives way to what holds it: its stiffness and a weight that keeps every vertex where it is, factored.
#pragma once

#include <span>
#include <vector>

#include "core/base/fork_join.h"
#include "core/base/precision.h"
#include "core/lri/lri.h"
#include "core/sparse/cholesky.h"

namespace shapespline {

/// What the system is made of. The reference pose's cotangent stiffness is the one of the second system.
struct HoldMesh {
  const WeldedShape& shape;
  std::span<const int> localFrameOf;       ///< of each face; -1 where it has no area
  std::span<const ComponentJoint> joints;  ///< where components are joined
  std::span<const LooseVertex> loose;
};

/// Twice the distance of the farthest position from the centroid: the same whichever way the shape is turned, which the
/// diagonal of its box is not.
double sizeOf(const Positions& positions);

/// Of each face in the reference pose, as a share of the whole; 0 without area.
std::vector<double> faceAreas(const HoldMesh& mesh);

/// The same per vertex, which has a third of its faces' areas.
std::vector<double> vertexAreas(const HoldMesh& mesh);

/// Cotangent of corner c of a face in the reference pose, halved: what ties the other two corners.
double sideStiffness(const HoldMesh& mesh, std::size_t face, int c);

/// Of each vertex in K: what its neighbours hold it with.
std::vector<double> stiffnessDiagonal(const HoldMesh& mesh);

/// Displacements x with (K + diag(weight)) x = b. Immutable.
class HoldSystem {
 public:
  /// weight: of each vertex, not negative. Error: that of the solver.
  static Result<HoldSystem> create(const HoldMesh& mesh, std::span<const double> weight, Precision precision);

  struct Scratch {
    std::vector<float> single;
    std::vector<double> whole;
  };

  /// Moves the vertices of a shape by the displacements that belong to a pull at each of them.
  void addSolved(const Positions& pull, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const;

 private:
  HoldSystem() = default;
  template <class Real>
  void addSolvedIn(std::vector<Real>& x, const Positions& pull, Positions& shape, ForkJoin* forkJoin) const;

  Cholesky solver_;
  Precision precision_ = Precision::Single;
  std::vector<int> slot_;
};

}  // namespace shapespline
