// A coarse mesh drives the full shape: the deformation transfer of the paper (section 4.3), on top of another motion.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/base/types.h"
#include "core/mesh/weld.h"
#include "core/sparse/cholesky.h"

namespace shapespline {

/// A coarse mesh, and its correspondence with the full mesh.
struct Leader {
  std::vector<Triangle> faces;
  std::vector<int> faceOf;    ///< the coarse face that each full face follows, or -1
  std::vector<int> vertexOf;  ///< the coarse vertex that each full vertex follows, or -1
};

/// Transfers corrections of a coarse mesh to shapes of the full mesh. Immutable.
class DeformationTransfer {
 public:
  /// faces, keys: the full mesh; vertices that coincide in all keys are merged. The first key is the reference.
  /// Errors: those of the solver.
  static Result<DeformationTransfer> create(const std::vector<Triangle>& faces, const std::vector<Positions>& keys,
                                            Leader leader, const FractionReport& onProgress = {});

  /// Deforms `shape` as its coarse mesh deforms between `from` and `to`. Every face gets the deformation of its coarse
  /// face; the vertices are the least-squares fit, in the metric of the reference. Each component is translated by the
  /// mean displacement of its coarse vertices.
  Positions follow(const Positions& shape, const Positions& from, const Positions& to) const;

 private:
  DeformationTransfer(Welding welding, const std::vector<Triangle>& faces, Leader leader)
      : welding_(std::move(welding)), faces_(weldFaces(faces, welding_)), leader_(std::move(leader)) {}
  std::vector<Mat3> deformations(const Positions& from, const Positions& to) const;
  void place(Positions& solution, const Positions& shape, const Positions& from, const Positions& to) const;

  Welding welding_;
  std::vector<Triangle> faces_;
  Leader leader_;
  std::vector<std::array<double, 3>> cotangent_;  // one per face and opposite side; 0 for a face without area
  std::vector<int> componentOf_;                  // one per vertex; -1 if no face with area has the vertex
  Cholesky solver_;
};

}  // namespace shapespline
