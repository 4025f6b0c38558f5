// The welded shape at any weights, whatever its frames come from and in whichever precision it is stored.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/sparse/cholesky.h"
#include "core/sequence/options.h"
#include "core/patches/patch_motion.h"
#include "core/reconstruct/reconstruct.h"
#include "core/sequence/sequence_stats.h"
#include "core/ghost/ghost_motion.h"

namespace shapespline {

class ShapeMotion {
 public:
  /// Encodes the poses and factorises, with a ghost if the options ask for one that is smaller than the shape. The shape must outlive the motion. Counts and times go to stats.
  /// Errors: NoArea, and those of the solver.
  static Result<std::unique_ptr<ShapeMotion>> create(const WeldedShape& shape, const EncodingOptions& options,
                                                     SequenceStats& stats, const StageProgress& progress);

  virtual ~ShapeMotion() = default;

  /// Both return the number of faces whose interpolated S_f is not positive definite.
  virtual int at(const CurvePoint& point, Positions& welded) = 0;
  /// placed: what is drawn. The parts' wall times go to stats.
  virtual int at(const CurvePoint& point, PlacedShape<float>& placed, SequenceStats& stats, Crew* crew) = 0;

  /// The shape as embedded in its frames (embedding.h): cheap and close. The embedding is made when it is first asked for.
  /// Error: that of its solver.
  virtual Status previewAt(const CurvePoint& point, PlacedShape<float>& placed) = 0;

  /// The patches that everything follows.
  virtual PatchMotion& patchMotion() = 0;
  virtual const PatchMotion& patchMotion() const = 0;

  /// The ghost that leads the shape, or null.
  virtual GhostMotion* ghost() = 0;

  /// Patch of each face; -1 where it has no area.
  virtual const std::vector<int>& patchOfFace() const = 0;
  /// Component of each face, numbered by their first faces; -1 where it has no area.
  virtual const std::vector<int>& componentOfFace() const = 0;
  virtual Eigen::MatrixXd gram(double diagonal) const = 0;
  virtual const std::vector<Vec3>& meanPosition() const = 0;  ///< one a column
  /// Of each welded vertex, a permutation that brings neighbours together (reconstruct.h).
  virtual const std::vector<int>& placeOf() const = 0;
  virtual const std::vector<AmbiguousFaces>& ambiguousFaces() const = 0;  ///< one per interval between keys
  virtual CholeskyStats solverStats() const = 0;
};

}  // namespace shapespline
