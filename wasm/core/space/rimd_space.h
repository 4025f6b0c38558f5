// Rotation-invariant mesh differences of faces (Gao et al. 2016): rotations of each face relative to its neighbours.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/compressed_rows.h"
#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// A shape of this space is the shape v with face rotations R that minimises
///   sum_f A_f |grad v - R_f S_f|^2 + sum_fg w_fg |R_g - R_f dR_fg|^2.
/// dR_fg = R_f^T R_g has a separate rotation path through the keys, and S_f is splined. w_fg is half the mean of both
/// areas, reduced for large relative rotations. fg runs over every pair of neighbours in both directions. The
/// minimisation starts at the shape of LRI space and takes three steps, each of which computes all R from v and their
/// neighbours, then v from R. The keys are exact minima. Immutable.
class RimdSpace {
 public:
  struct Scratch {
    RotationBlocks<double> differences;  // differences of the pairs
    Positions positions;
    std::vector<Quaternion> rotation, before;
    std::vector<double> stretch;
  };

  /// Both must outlive the space. Requires stretches of the shape's faces, so not with Transfer::Paper.
  RimdSpace(const WeldedKeys& keys, const LriSpace& lri);

  /// shape: LRI space's shape at `point`, replaced by this space's. Real: the type of LRI space's reconstructor.
  template <class Real>
  Reconstruction improve(const CurvePoint& point, const Reconstructor<Real>& reconstructor, Scratch& scratch,
                         typename Reconstructor<Real>::Scratch& ofReconstructor, PaddedShape<Real>& shape,
                         ForkJoin* forkJoin = nullptr) const;

  /// Inner products of the columns (path_gram.h), with equal weights for all pairs.
  Eigen::MatrixXd gramMatrix() const;

 private:
  // A face of a pair, relative to the other face.
  struct Side {
    int face, pair;
    double weight;
    bool isFirst;  // the pair's difference starts at this face
  };

  Quaternion startOf(const Positions& positions, int face) const;
  Quaternion agreeing(int face, const Scratch& scratch) const;
  FaceDeformation deformationIn(const Positions& positions, int face) const;

  const WeldedKeys* keys_;
  const LriSpace* lri_;
  std::vector<int> used_;            // faces with area
  std::vector<FaceFrame> frame_;     // one per face
  std::vector<int> slotOf_;          // slot of each face
  CompressedRows<Side> neighbours_;  // neighbours of each face; empty without area
  RotationPaths<double> differences_;
  int pairs_ = 0;
};

}  // namespace shapespline
