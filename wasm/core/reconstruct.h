// Coordinates -> vertices: patch rotations, then the Poisson system, then the places of components and loose vertices.
#pragma once

#include <functional>
#include <vector>

#include "core/alignment.h"
#include "core/face_kernel.h"
#include "core/lri.h"
#include "core/patch_rotations.h"
#include "core/poisson.h"
#include "core/spline.h"

namespace shapespline {

/// Weights over the poses that were encoded.
struct PoseWeights {
  std::vector<double> column;  ///< one a column of the coordinates; the closing weight is counted in the first key's
  double closing = 0;          ///< that weight, for the numbers that wind
};

PoseWeights poseWeights(const Weights& weights, const WeldedShape& shape);

/// Called with a stage's name and the fraction of that stage that is done.
using StageProgress = std::function<void(const char* stage, double fraction)>;

/// Rebuilds shapes from blended coordinates. Holds both factored systems and scratch space; not thread-safe, but every
/// result depends on its arguments alone.
template <class Real>
class Reconstructor {
 public:
  /// Analyses and factorises both systems. The shape must outlive this object.
  Status build(const WeldedShape& shape, LriCoordinates<Real> coordinates, const EncodingOptions& options,
               const StageProgress& onProgress);

  /// The shape at `weights`, its mean position where the coordinates have it. xyz: 3 numbers a welded vertex.
  /// Returns the number of faces whose interpolated S_f is not positive definite.
  int reconstruct(const Weights& weights, std::vector<Real>& xyz);

  /// Patch rotations at `weights`, up to one common rotation. Components hang on their anchors.
  void patchRotations(const Weights& weights, std::vector<Quaternion>& rotation);

  Vec3 meanPosition(const Weights& weights) const;

  const LriCoordinates<Real>& coordinates() const { return lri_; }
  Alignment& alignment() { return alignment_; }
  const Alignment& alignment() const { return alignment_; }
  CholeskyStats solverStats() const { return poisson_.stats(); }

 private:
  void solvePatches(const PoseWeights& weights, std::vector<Quaternion>& rotation);
  void hangComponents(const PoseWeights& weights, std::vector<Quaternion>& rotation) const;
  Quaternion faceRotation(int face, const PoseWeights& weights, const std::vector<Quaternion>& rotation) const;
  int solveVertices(const PoseWeights& weights, const std::vector<Quaternion>& rotation);
  void placeComponents(const PoseWeights& weights, const std::vector<Quaternion>& rotation);
  void writeVertices(const PoseWeights& weights, const std::vector<Quaternion>& rotation, std::vector<Real>& xyz) const;
  Vec3 placedVertex(int v) const;
  Vec3 placedCentroid(int face) const;

  const WeldedShape* shape_ = nullptr;
  LriCoordinates<Real> lri_;
  PatchRotationSystem patchSystem_;
  PoissonSystem poisson_;
  FaceKernel<Real> kernel_;
  Alignment alignment_;
  std::vector<int> pieceOfVertex_;             // -1 for loose vertices
  std::vector<std::vector<int>> patchesOf_;    // patches of each piece

  // scratch, overwritten by every reconstruction
  std::vector<Real, Eigen::aligned_allocator<Real>> solution_;
  std::vector<Real> frames_, columnWeights_;
  std::vector<Quaternion> rotation_;
  std::vector<Vec3> pair_, shift_;             // shift_: translation of each piece
};

}  // namespace shapespline
