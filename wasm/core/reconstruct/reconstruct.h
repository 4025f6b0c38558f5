// Coordinates -> vertices: the frames' rotations, then the Poisson system, then the places of components and loose vertices.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/reconstruct/preview_embedding.h"
#include "core/reconstruct/face_kernel.h"
#include "core/lri/frame_source.h"
#include "core/lri/lri.h"
#include "core/reconstruct/poisson.h"
#include "core/spline/pose_weights.h"
#include "core/sequence/sequence_stats.h"

namespace shapespline {

/// Called with a stage's name and the fraction of that stage that is done.
using StageProgress = std::function<void(const char* stage, double fraction)>;

/// A shape as it leaves the solver.
template <class Real>
struct PlacedShape {
  std::vector<Real> places;  ///< (x, y, z, pad) of each welded vertex in the order of placeOf(); more may follow
  Vec3 move = Vec3::Zero();  ///< what all of them are still to be moved by
};

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

  /// Orders and factorises the system and lays the faces' numbers out for it; the times of that go to stats.
  Status build(const Input& input, LriCoordinates<Real> coordinates, SequenceStats& stats, const StageProgress& onProgress);

  /// The shape at `point`, its mean position where the coordinates have it. Returns the number of faces whose interpolated
  /// S_f is not positive definite. The parts' wall times go to stats, if there is one.
  int reconstruct(const CurvePoint& point, PlacedShape<Real>& shape, SequenceStats* stats = nullptr, Crew* crew = nullptr);

  /// The same as one position a welded vertex.
  int reconstruct(const CurvePoint& point, Positions& positions);

  /// The shape at `point`, about (embedding.h), made for it when it is first asked for. poses: the frames that the
  /// coordinates are in. Error: that of the embedding's solver.
  Status preview(const CurvePoint& point, const FramePoses& poses, PlacedShape<float>& shape);

  /// R_f of every face at `point`; the identity for faces without area.
  void faceRotations(const CurvePoint& point, std::vector<Quaternion>& rotation);

  const LriCoordinates<Real>& coordinates() const { return lri_; }
  CholeskyStats solverStats() const { return poisson_.stats(); }

  /// Component of each face, -1 without area.
  const std::vector<int>& pieceOfFace() const { return pieceOfFace_; }

  /// Of each welded vertex, a permutation: as they are eliminated, then those that are not. Neighbours of the mesh are near
  /// each other in this order, so that passes over it stay in the processor's caches.
  const std::vector<int>& placeOf() const { return placeOf_; }

 private:
  Quaternion faceRotation(int face, int frame, const PoseWeights& weights) const;
  Status embed(const FramePoses& poses);
  // x: (x, y, z, pad) of each slot; the right-hand side and then the solution.
  int assemble(const PoseWeights& weights, Real* x, Crew* crew);
  void solve(const PoseWeights& weights, Real* x, Crew* crew);
  void startFromKey(const PoseWeights& weights, Real* x);
  void placeComponents(const PoseWeights& weights, const Real* x);
  void placeLoose(const PoseWeights& weights, const Real* x);
  Vec3 meanMove(const PoseWeights& weights, const Real* x) const;
  void slotsToPlaces(Real* x);
  Vec3 placedVertex(int v, const Real* x) const;
  Vec3 placedCentroid(int face, const Real* x) const;

  const WeldedShape* shape_ = nullptr;
  FrameSource* source_ = nullptr;
  LriCoordinates<Real> lri_;
  PoissonSystem poisson_;
  FaceKernel<Real> kernel_;
  Precision precision_ = Precision::Single;
  Stretch stretch_ = Stretch::Linear;
  double extent_ = 0;  // diagonal of the reference pose
  std::vector<int> frameOf_;
  std::vector<int> pieceOfVertex_;  // -1 for loose vertices
  std::vector<int> placeOf_;
  std::vector<int> pieceAt_;        // of the vertex at each place; 0 for loose vertices. Empty where there is one piece only
  std::vector<int> verticesOfPiece_;
  std::vector<int> pieceOfFace_;
  std::optional<Embedding> embedding_;

  std::vector<int> faceAt_;         // of each slot of the coordinates

  // scratch, overwritten by every reconstruction
  int indefiniteFace_ = -1;
  std::vector<Real> rightHandSide_;  // with Precision::Exact
  Frames frames_;
  std::vector<Real> matrices_;
  PlacedShape<Real> placed_;
  std::vector<Vec3> shift_;       // translation of each piece against the others
  std::vector<Real> shiftLanes_;  // the same as (x, y, z, 0)
  std::vector<Vec3> loose_;       // where each loose vertex lies
};

}  // namespace shapespline
