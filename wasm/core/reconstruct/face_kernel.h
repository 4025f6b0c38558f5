// Coordinates -> right-hand side of the second system, four faces at a time: spline, exponential, product, divergence.
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

/// What stretches of four faces take.
inline constexpr int stretchBlock = 3 * faceLanes;

/// A frame's matrix in the kernel: its columns, four numbers each, the last of them zero.
inline constexpr int numbersPerFrame = 12;

/// What a face contributes that does not depend on time. Lanes of one block lie side by side.
template <class Real>
struct FaceBlock {
  Real tangent[6][faceLanes];  ///< t1 and t2 of the reference frame, xyz each
  /// Area times the hat functions' gradients, in (t1, t2): (-a, b) of corner 0, (a, c) of 1.
  Real gradient[3][faceLanes];
  std::int32_t frame[faceLanes];      ///< index into the frames
  std::int32_t corner[3][faceLanes];  ///< where each corner's right-hand side lies
};

/// What stands before S_f: of each frame the matrix G that stands before exp(r_f), numbersPerFrame numbers each; or of
/// the faces themselves the rotations R_f (rotation_blocks.h), and null otherwise.
template <class Real>
struct FaceTurns {
  const Real* frames = nullptr;
  const Real* faces = nullptr;
};

/// Faces whose interpolated S_f is not positive definite.
struct IndefiniteFaces {
  int count = 0;
  int slot = -1;  ///< of one of them, in the order of the coordinates
};

/// Faces of the welded mesh, ready to be evaluated.
template <class Real>
class FaceKernel {
 public:
  /// frameOf: frame of each face, or -1 for faces that take no part. position: where each vertex's right-hand side
  /// lies, or `trashSlot`, behind all others, for vertices that have none.
  FaceKernel(const WeldedShape& shape, const std::vector<int>& localFrameOf, Stretch stretch,
             const std::vector<int>& position, int trashSlot, const FractionReport& onProgress = {});

  /// The faces in the order in which they are gone through and in which their coordinates must lie.
  const std::vector<int>& order() const { return order_; }

  /// Adds the divergence of R_f S_f of every face to rhs, (x, y, z, pad) per position.
  /// weights: as the coordinates take them.
  IndefiniteFaces accumulate(const FaceCoordinates<Real>& coordinates, const FaceTurns<Real>& turns,
                             const ColumnWeights<Real>& weights, Real* rhs, ForkJoin* forkJoin = nullptr) const;

  /// R_f of every face as accumulate() takes it. frames: of each frame G as x, y, z, w.
  void rotations(const FaceCoordinates<Real>& coordinates, const std::vector<Real>& frames,
                 const ColumnWeights<Real>& weights, RotationBlocks<Real>& rotations,
                 ForkJoin* forkJoin = nullptr) const;

  /// S_f of every face as accumulate() takes it: xx, xy, yy in the tangent frame, [block][number][lane].
  void stretches(const FaceCoordinates<Real>& coordinates, const ColumnWeights<Real>& weights,
                 std::vector<Real>& stretch) const;

 private:
  void blockRotation(std::size_t block, const FaceCoordinates<Real>& coordinates, const std::vector<Real>& frames,
                     const ColumnWeights<Real>& weights, Real* rotation) const;
  [[gnu::noinline]] IndefiniteFaces accumulateRange(const FaceRange& range, const FaceCoordinates<Real>& coordinates,
                                                    const FaceTurns<Real>& turns, const ColumnWeights<Real>& weights,
                                                    Real* rhs) const;

  std::vector<int> order_;
  std::vector<FaceBlock<Real>> blocks_;
  std::array<FaceRange, 3> ranges_;
  Stretch stretch_ = Stretch::Linear;
};

}  // namespace shapespline
