// The full shape led by a coarse mesh: the deformation transfer of the paper (section 4.3), on top of another motion.
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

/// A coarse mesh, and which of its faces and vertices a full one follows.
struct Leader {
  std::vector<Triangle> faces;
  std::vector<int> faceOf;    ///< of each full face: a coarse one, or -1
  std::vector<int> vertexOf;  ///< of each full vertex: a coarse one, or -1
};

/// Corrects shapes of the full mesh where their coarse meshes are corrected. Immutable.
class LedShape {
 public:
  /// faces, keys: of the full mesh; copies of a vertex that coincide in all keys are one. The first key is the
  /// reference. Errors: those of the solver.
  static Result<LedShape> create(const std::vector<Triangle>& faces, const std::vector<Positions>& keys, Leader leader,
                                 const FractionReport& onProgress = {});

  /// `shape`, whose coarse mesh lies at `from`, as it is where that lies at `to`: every face is deformed as the one
  /// that it follows, and the vertices fit that best (least squares, in the metric of the reference). Each component
  /// goes where its coarse vertices go in the mean.
  Positions follow(const Positions& shape, const Positions& from, const Positions& to) const;

 private:
  LedShape(Welding welding, const std::vector<Triangle>& faces, Leader leader)
      : welding_(std::move(welding)), faces_(weldFaces(faces, welding_)), leader_(std::move(leader)) {}
  std::vector<Mat3> deformations(const Positions& from, const Positions& to) const;
  void place(Positions& solution, const Positions& shape, const Positions& from, const Positions& to) const;

  Welding welding_;
  std::vector<Triangle> faces_;
  Leader leader_;
  std::vector<std::array<double, 3>> cotangent_;  // of each face, opposite its sides; 0 without area
  std::vector<int> componentOf_;                  // of each vertex, or -1 in no face with area
  Cholesky solver_;
};

}  // namespace shapespline
