// Coordinates -> vertices: the frames' rotations, then the Poisson system, then the places of components and loose vertices.
#pragma once

#include <functional>
#include <vector>

#include "core/face_kernel.h"
#include "core/frame_source.h"
#include "core/lri.h"
#include "core/poisson.h"
#include "core/pose_weights.h"

namespace shapespline {

/// Called with a stage's name and the fraction of that stage that is done.
using StageProgress = std::function<void(const char* stage, double fraction)>;

/// Rebuilds shapes from blended coordinates. Holds the factored system and scratch space; not thread-safe, but every
/// result depends on its arguments alone.
template <class Real>
class Reconstructor {
 public:
  struct Input {
    const WeldedShape& shape;     ///< must outlive the reconstructor
    const ShapeParts& parts;
    std::span<const int> frameOf; ///< frame of each face; -1 where it has no area
    FrameSource& frames;          ///< must outlive the reconstructor
    Stretch stretch;
    Precision precision;
  };

  /// Analyses and factorises the system.
  Status build(const Input& input, LriCoordinates<Real> coordinates, const StageProgress& onProgress);

  /// The shape at `weights`, its mean position where the coordinates have it. xyz: 3 numbers a welded vertex.
  /// Returns the number of faces whose interpolated S_f is not positive definite.
  int reconstruct(const Weights& weights, std::vector<Real>& xyz);

  /// R_f of every face at `weights`; the identity for faces without area.
  void faceRotations(const Weights& weights, std::vector<Quaternion>& rotation);

  const LriCoordinates<Real>& coordinates() const { return lri_; }
  CholeskyStats solverStats() const { return poisson_.stats(); }

 private:
  Quaternion faceRotation(int face, int frame, const PoseWeights& weights) const;
  int solveVertices(const PoseWeights& weights);
  void placeComponents(const PoseWeights& weights);
  void writeVertices(const PoseWeights& weights, std::vector<Real>& xyz) const;
  Vec3 placedVertex(int v) const;
  Vec3 placedCentroid(int face) const;

  const WeldedShape* shape_ = nullptr;
  FrameSource* source_ = nullptr;
  LriCoordinates<Real> lri_;
  PoissonSystem poisson_;
  FaceKernel<Real> kernel_;
  std::vector<int> frameOf_;
  std::vector<int> pieceOfVertex_;  // -1 for loose vertices

  // scratch, overwritten by every reconstruction
  std::vector<Real, Eigen::aligned_allocator<Real>> solution_;
  Frames frames_;
  std::vector<Real> matrices_, columnWeights_;
  std::vector<Vec3> shift_;  // translation of each piece
};

}  // namespace shapespline
