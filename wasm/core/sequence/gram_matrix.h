// Measures of shapes and of sequences of shapes.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"
#include "core/base/types.h"

namespace shapespline {

/// Signed volume enclosed by the faces (divergence theorem): right for closed, consistently wound meshes.
double enclosedVolume(const Positions& positions, const std::vector<Triangle>& faces);
double surfaceArea(const Positions& positions, const std::vector<Triangle>& faces);

/// What E(A) in the KG error is.
enum class KgCentre {
  FrameCentroid,    ///< each frame's own centroid (Karni & Gotsman 2004)
  SequenceAverage,  ///< the average shape over all frames
};

/// Karni-Gotsman error of `other` against `sequence` (paper Eq. 7): 100 |A - A~|_F / |A - E(A)|_F. Same frame counts.
double kgError(const std::vector<Positions>& sequence, const std::vector<Positions>& other,
               KgCentre centre = KgCentre::FrameCentroid);

/// Inner products of the coordinates' columns (poses), columns x columns. The metric: face numbers weighted by the face's
/// share of the reference area, patch pairs by their share of the shared edges, mean positions over the diagonal; angles
/// in radians. The mean rotation moves on its own path and is left out.
template <class Real>
Eigen::MatrixXd gramMatrix(const PatchCoordinates& patches, const LriCoordinates<Real>& coordinates,
                           const WeldedShape& shape, double diagonal);

/// The plane of the two leading principal components of the first `keys` columns.
class PrincipalPlane {
 public:
  PrincipalPlane(const Eigen::MatrixXd& gram, int keys);
  /// Coordinates of an affine combination of the columns.
  Vec2 project(const Eigen::VectorXd& columnWeights) const;
  /// Share of the keys' variance in the plane, in [0, 1].
  double explained() const { return explained_; }

 private:
  Eigen::MatrixXd gram_;
  Eigen::VectorXd mean_;       // weights of the keys' mean
  Eigen::MatrixXd direction_;  // columns x 2: weights of the axes, unit length in the metric
  double explained_ = 0;
};

/// The rotation and the largest distance that remain when `from` is moved rigidly onto `to` (least squares, Kabsch).
struct RigidFit {
  Mat3 rotation;
  double largestDistance = 0;
};
RigidFit fitRigid(const Positions& from, const Positions& to);

}  // namespace shapespline
