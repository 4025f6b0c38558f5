// Computes vertices from coordinates: the frames' rotations, then the Poisson system, then positions of components and
// loose vertices.
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

/// A shape as returned by the solver.
template <class Real>
struct PaddedShape {
  /// (x, y, z, pad) of each welded vertex in the order of slotOf(), possibly followed by padding
  std::vector<Real> xyzp;
  Vec3 move = Vec3::Zero();  ///< translation still to be added to all positions
};

/// Statistics of a reconstruction, with wall times in ms: splined faces and right-hand side; the solve; placing the
/// vertices.
struct Reconstruction {
  int indefiniteFaces = 0;  ///< number of faces whose interpolated S_f is not positive definite
  int indefiniteFace = -1;  ///< one such face, or -1
  double facesMs = 0, solveMs = 0, positionsMs = 0;
};

/// Reconstructs shapes from blended coordinates. Holds the factored system. Immutable.
template <class Real>
class Reconstructor {
 public:
  struct Input {
    const WeldedShape& shape;  ///< must outlive the reconstructor
    const ShapeTopology& topology;
    std::span<const int> localFrameOf;  ///< frame of each face, or -1 without area
    Stretch stretch;
    Precision precision;
    OrderSource order = nullptr;
  };

  /// Scratch memory, overwritten by every reconstruction.
  struct Scratch {
    std::vector<Real> rightHandSide;  // only with Precision::Exact
    IterativeRefinement::Scratch refinement;
    std::vector<Real> matrices;  // matrices of the frames
    PaddedShape<Real> padded;
    std::vector<Vec3> shift;       // translation of each component relative to the others
    std::vector<Real> shiftLanes;  // shift as (x, y, z, 0)
    std::vector<Vec3> loose;       // position of each loose vertex
  };

  /// Wall times, ms. Arranging sorts the faces' numbers by the elimination order of the system.
  struct Times {
    double order = 0, factor = 0, arrange = 0;
  };

  /// Orders and factors the system, and arranges the faces' numbers. Error: the solver's.
  static Result<Reconstructor> create(const Input& input, LriCoordinates<Real> coordinates,
                                      const StageProgress& onProgress = {});

  /// The shape at `point` with the given frames, with the mean position of the coordinates.
  Reconstruction reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin = nullptr) const;

  /// The shape at `point` as one position per welded vertex.
  Reconstruction reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                             Positions& positions) const;

  /// Reconstructs with a given rotation R_f for every face, instead of rotations relative to frames.
  Reconstruction reconstruct(const CurvePoint& point, const RotationBlocks<Real>& rotations, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin = nullptr) const;

  /// S_f of every face at `point`, in kernel layout (face_kernel.h).
  void stretchesAt(const CurvePoint& point, std::vector<Real>& stretch) const;

  /// One position per welded vertex of a reconstructed shape.
  void positionsOf(const PaddedShape<Real>& shape, Positions& positions) const;

  /// R_f of every face at `point` with the given frames; the identity for faces without area.
  void faceRotations(const CurvePoint& point, const LocalFrames& frames, std::vector<Quaternion>& rotation) const;

  const LriCoordinates<Real>& coordinates() const { return lri_; }
  CholeskyStats solverStats() const { return poisson_.stats(); }
  const Times& times() const { return times_; }

  /// A permutation of the welded vertices: in elimination order, then the others. Mesh neighbours are close in this
  /// order, so passes over it stay in the processor's caches.
  const std::vector<int>& slotOf() const { return slotOf_; }

 private:
  Reconstructor(const Input& input, LriCoordinates<Real> coordinates, PoissonSystem poisson,
                const FractionReport& onProgress);
  // Weights of the poses: for the mean position, and for each part of the curve.
  struct FrameWeights {
    PoseWeights position;
    std::vector<PoseWeights> parts;
    std::span<const int> partOf;  // of each frame; empty with one part
    const PoseWeights& of(int frame) const { return parts[partOf.empty() ? 0 : partOf[frame]]; }
  };
  // Either frames for the faces, or the faces' rotations.
  struct Turning {
    const LocalFrames* frames = nullptr;
    const RotationBlocks<Real>* faces = nullptr;
  };
  FrameWeights weightsAt(const CurvePoint& point, const Turning& turning) const;
  Quaternion faceRotation(int face, int frame, const FrameWeights& weights, const Turning& turning) const;
  Reconstruction reconstruct(const CurvePoint& point, const Turning& turning, Scratch& scratch,
                             PaddedShape<Real>& shape, ForkJoin* forkJoin) const;
  // x: (x, y, z, pad) per slot; first the right-hand side, then the solution.
  IndefiniteFaces assemble(const FrameWeights& weights, const Turning& turning, Scratch& scratch, Real* x,
                           ForkJoin* forkJoin) const;
  void solve(const FrameWeights& weights, Scratch& scratch, Real* x, ForkJoin* forkJoin) const;
  // Adds the divergence of the torn faces' gradients.
  void addTornFaces(const FrameWeights& weights, const Turning& turning, Real* x) const;
  void startFromKey(const FrameWeights& weights, Scratch& scratch, Real* x) const;
  void moveComponents(const FrameWeights& weights, const Turning& turning, Scratch& scratch, const Real* x) const;
  void moveLoose(const FrameWeights& weights, const Turning& turning, Scratch& scratch, const Real* x) const;
  Vec3 meanMove(const FrameWeights& weights, const Scratch& scratch, const Real* x) const;
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
  double extent_ = 0;                   // bounding diagonal of the reference pose
  std::vector<int> componentOfVertex_;  // -1 for loose vertices
  std::vector<int> slotOf_;
  // component of the vertex in each slot, 0 for loose vertices; empty for a single component
  std::vector<int> componentAt_;
  std::vector<int> verticesOfComponent_;
  Times times_;
};

}  // namespace shapespline
