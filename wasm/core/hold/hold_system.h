// The response of a shape to holding forces: the factored sum of its stiffness and a positional weight at every vertex.
#pragma once

#include <span>
#include <vector>

#include "core/base/fork_join.h"
#include "core/base/precision.h"
#include "core/lri/lri.h"
#include "core/sparse/cholesky.h"

namespace shapespline {

/// Input of the system. The cotangent stiffness of the reference pose is the same as in the second system.
struct HoldMesh {
  const WeldedShape& shape;
  std::span<const int> localFrameOf;       ///< frame of each face, -1 without area
  std::span<const ComponentJoint> joints;  ///< joints of components
  std::span<const LooseVertex> loose;
};

/// Twice the distance of the farthest position from the centroid. Unlike the diagonal of the bounding box, it does not
/// depend on the orientation.
double sizeOf(const Positions& positions);

/// Share of each face in the total area, in the reference pose; 0 without area.
std::vector<double> faceAreas(const HoldMesh& mesh);

/// Share of each vertex in the total area: a third of its faces' areas.
std::vector<double> vertexAreas(const HoldMesh& mesh);

/// Half the cotangent at corner c of a face in the reference pose: the stiffness between the other two corners.
double sideStiffness(const HoldMesh& mesh, std::size_t face, int c);

/// Diagonal entry of K for each vertex: the total stiffness to its neighbours.
std::vector<double> stiffnessDiagonal(const HoldMesh& mesh);

/// Displacements x with (K + diag(weight)) x = b. Immutable.
class HoldSystem {
 public:
  /// weight: one per vertex, not negative. Error: the solver's.
  static Result<HoldSystem> create(const HoldMesh& mesh, std::span<const double> weight, Precision precision);

  struct Scratch {
    std::vector<float> single;
    std::vector<double> whole;
  };

  /// Adds the displacements caused by a pull at each vertex.
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
