// Coordinates -> vertices: the frames' rotations, then the Poisson system, then the positions of components and loose
// vertices.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/lri/local_frames.h"
#include "core/lri/lri.h"
#include "core/reconstruct/face_kernel.h"
#include "core/reconstruct/poisson.h"
#include "core/spline/pose_weights.h"

namespace shapespline {

/// A shape as it leaves the solver.
template <class Real>
struct PaddedShape {
  std::vector<Real> xyzp;    ///< (x, y, z, pad) of each welded vertex in the order of slotOf(); more may follow
  Vec3 move = Vec3::Zero();  ///< what all of them are still to be moved by
};

/// What a reconstruction found, and the wall times of its parts, ms: splined faces and right-hand side; the solve;
/// placing the vertices.
struct Reconstruction {
  int indefiniteFaces = 0;  ///< faces whose interpolated S_f is not positive definite
  int indefiniteFace = -1;  ///< one of them
  double facesMs = 0, solveMs = 0, positionsMs = 0;
};

/// Rebuilds shapes from blended coordinates. Holds the factored system. Immutable.
template <class Real>
class Reconstructor {
 public:
  struct Input {
    const WeldedShape& shape;  ///< must outlive the reconstructor
    const ShapeTopology& topology;
    std::span<const int> localFrameOf;  ///< frame of each face; -1 where it has no area
    Stretch stretch;
    Precision precision;
    OrderSource order = nullptr;
  };

  /// Overwritten by every reconstruction.
  struct Scratch {
    std::vector<Real> rightHandSide;  // with Precision::Exact
    IterativeRefinement::Scratch refinement;
    std::vector<Real> matrices;  // of the frames
    PaddedShape<Real> padded;
    std::vector<Vec3> shift;       // translation of each component against the others
    std::vector<Real> shiftLanes;  // the same as (x, y, z, 0)
    std::vector<Vec3> loose;       // where each loose vertex lies
  };

  /// Wall times, ms. Arranging lays the faces' numbers out in the order in which the system is eliminated.
  struct Times {
    double order = 0, factor = 0, arrange = 0;
  };

  /// Orders and factors the system and lays the faces' numbers out for it. Error: that of the solver.
  static Result<Reconstructor> create(const Input& input, LriCoordinates<Real> coordinates,
                                      const StageProgress& onProgress = {});

  /// The shape at `point` in the frames there, its mean position where the coordinates have it.
  Reconstruction reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin = nullptr) const;

  /// The same as one position per welded vertex.
  Reconstruction reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                             Positions& positions) const;

  /// The same where every face has a rotation of its own instead of one that follows a frame. rotations: R_f.
  Reconstruction reconstruct(const CurvePoint& point, const RotationBlocks<Real>& rotations, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin = nullptr) const;

  /// R_f of every face at `point` in the frames there, for the kernel; those of faces without area mean nothing.
  void rotationsAt(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                   RotationBlocks<Real>& rotations, ForkJoin* forkJoin = nullptr) const;

  /// S_f of every face at `point`, as the kernel lays them out (face_kernel.h).
  void stretchesAt(const CurvePoint& point, std::vector<Real>& stretch) const;

  /// One position per welded vertex of a shape that was reconstructed.
  void positionsOf(const PaddedShape<Real>& shape, Positions& positions) const;

  /// R_f of every face at `point` in the frames there; the identity for faces without area.
  void faceRotations(const CurvePoint& point, const LocalFrames& frames, std::vector<Quaternion>& rotation) const;

  const LriCoordinates<Real>& coordinates() const { return lri_; }
  CholeskyStats solverStats() const { return poisson_.stats(); }
  const Times& times() const { return times_; }

  /// Of each welded vertex, a permutation: as they are eliminated, then those that are not. Neighbours of the mesh are
  /// near each other in this order, so passes over it stay in the processor's caches.
  const std::vector<int>& slotOf() const { return slotOf_; }

 private:
  Reconstructor(const Input& input, LriCoordinates<Real> coordinates, PoissonSystem poisson,
                const FractionReport& onProgress);
  // Frames that faces follow, or the faces' own rotations.
  struct Turning {
    const LocalFrames* frames = nullptr;
    const RotationBlocks<Real>* faces = nullptr;
  };
  Quaternion faceRotation(int face, int frame, const PoseWeights& weights, const Turning& turning) const;
  Reconstruction reconstruct(const CurvePoint& point, const Turning& turning, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin) const;
  // x: (x, y, z, pad) of each slot; the right-hand side and then the solution.
  IndefiniteFaces assemble(const PoseWeights& weights, const Turning& turning, Scratch& scratch, Real* x,
                           ForkJoin* forkJoin) const;
  void solve(const PoseWeights& weights, Scratch& scratch, Real* x, ForkJoin* forkJoin) const;
  void startFromKey(const PoseWeights& weights, Scratch& scratch, Real* x) const;
  void moveComponents(const PoseWeights& weights, const Turning& turning, Scratch& scratch, const Real* x) const;
  void moveLoose(const PoseWeights& weights, const Turning& turning, Scratch& scratch, const Real* x) const;
  Vec3 meanMove(const PoseWeights& weights, const Scratch& scratch, const Real* x) const;
  void applyShifts(Scratch& scratch, Real* x) const;
  Vec3 shiftedVertex(int v, const Scratch& scratch, const Real* x) const;
  Vec3 shiftedCentroid(int face, const Scratch& scratch, const Real* x) const;

  const WeldedShape* shape_;
  Precision precision_;
  Stretch stretch_;
  std::vector<int> localFrameOf_;
  LriCoordinates<Real> lri_;
  PoissonSystem poisson_;
  FaceKernel<Real> kernel_;
  double extent_ = 0;                   // diagonal of the reference pose
  std::vector<int> componentOfVertex_;  // -1 for loose vertices
  std::vector<int> slotOf_;
  std::vector<int> componentAt_;  // of the vertex in each slot, 0 for loose ones; empty where there is one component
  std::vector<int> verticesOfComponent_;
  Times times_;
};

}  // namespace shapespline
