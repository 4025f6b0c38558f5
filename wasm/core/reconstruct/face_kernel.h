// Computes the right-hand side of the second system from coordinates, four faces at a time: spline, exponential,
// product, divergence.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/fork_join.h"
#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/lri/face_coordinates.h"
#include "core/lri/welded_shape.h"
#include "core/mesh/face_order.h"
#include "core/reconstruct/rotation_blocks.h"

namespace shapespline {

/// Number of stretch values for four faces.
inline constexpr int stretchBlock = 3 * faceLanes;

/// Size of a frame's matrix in the kernel: three columns of four numbers, the last number zero.
inline constexpr int numbersPerFrame = 12;

/// The time-independent data of a block of faces. Values of one lane array are contiguous.
template <class Real>
struct FaceBlock {
  Real tangent[6][faceLanes];  ///< t1 and t2 of the reference frame, xyz each
  /// Area times the hat functions' gradients, in (t1, t2): (-a, b) of corner 0, (a, c) of 1.
  Real gradient[3][faceLanes];
  std::int32_t frame[faceLanes];      ///< index of the local frame
  std::int32_t corner[3][faceLanes];  ///< position of each corner's right-hand side
};

/// The rotation factor before S_f. Either each frame's matrix G, which precedes exp(r_f), as numbersPerFrame numbers;
/// or the faces' rotations R_f (rotation_blocks.h). The other pointer is null.
template <class Real>
struct FaceTurns {
  const Real* frames = nullptr;
  const Real* faces = nullptr;
};

/// Faces whose interpolated S_f is not positive definite.
struct IndefiniteFaces {
  int count = 0;
  int slot = -1;  ///< slot of one such face in the coordinates
};

/// Faces of the welded mesh, prepared for evaluation.
template <class Real>
class FaceKernel {
 public:
  /// localFrameOf: frame of each face, or -1 to ignore the face. Torn faces count by their share that is not torn.
  /// position: position of each vertex's right-hand side, or
  /// `trashSlot`, after all others, for vertices without one.
  FaceKernel(const WeldedShape& shape, const ShapeTopology& topology, const std::vector<int>& localFrameOf,
             Stretch stretch, const std::vector<int>& position, int trashSlot, const FractionReport& onProgress = {});

  /// The face order of the kernel. The coordinates must use the same order.
  const std::vector<int>& order() const { return order_; }

  /// Adds the divergence of R_f S_f of every face to rhs, (x, y, z, pad) per position.
  /// weights: in the form used by the coordinates.
  IndefiniteFaces accumulate(const FaceCoordinates<Real>& coordinates, const FaceTurns<Real>& turns,
                             const ColumnWeights<Real>& weights, Real* rhs, ForkJoin* forkJoin = nullptr) const;

  /// S_f of every face, as used by accumulate(): xx, xy, yy in the tangent frame, [block][number][lane].
  void stretches(const FaceCoordinates<Real>& coordinates, const ColumnWeights<Real>& weights,
                 std::vector<Real>& stretch) const;

 private:
  [[gnu::noinline]] IndefiniteFaces accumulateRange(const FaceRange& range, const FaceCoordinates<Real>& coordinates,
                                                    const FaceTurns<Real>& turns, const ColumnWeights<Real>& weights,
                                                    Real* rhs) const;

  std::vector<int> order_;
  std::vector<FaceBlock<Real>> blocks_;
  std::array<FaceRange, 3> ranges_;
  Stretch stretch_ = Stretch::Linear;
};

}  // namespace shapespline
