// Rotation-invariant mesh differences (Gao et al. 2016), of faces: how each face rotates against its neighbours.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/compressed_rows.h"
#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// A shape of this space is the shape v with rotations R of its faces that is least in
///   sum_f A_f |grad v - R_f S_f|^2 + sum_fg w_fg |R_g - R_f dR_fg|^2
/// where dR_fg = R_f^T R_g moves through the keys by itself, S_f is splined and w_fg is half the mean of both areas,
/// less where the two turn far against each other; fg is every pair of neighbours, either way round. It begins at the
/// shape of LRI space and takes three steps, each of which finds all R from v and their neighbours, then v from R. At
/// keys nothing is left to improve. Immutable.
class RimdSpace {
 public:
  struct Scratch {
    RotationBlocks<double> differences;  // of the pairs
    Positions positions;
    std::vector<Quaternion> rotation, before;
    std::vector<double> stretch;
  };

  /// Both must outlive the space. The stretches must be those of the shape's own faces: not with Transfer::Paper.
  RimdSpace(const WeldedKeys& keys, const LriSpace& lri);

  /// shape: that of LRI space at `point`; becomes the one of this space. Real: of LRI space's reconstructor.
  template <class Real>
  Reconstruction improve(const CurvePoint& point, const Reconstructor<Real>& reconstructor, Scratch& scratch,
                         typename Reconstructor<Real>::Scratch& ofReconstructor, PaddedShape<Real>& shape,
                         ForkJoin* forkJoin = nullptr) const;

  /// Inner products of the columns (path_gram.h), every pair with the same weight.
  Eigen::MatrixXd gramMatrix() const;

 private:
  // One of the two faces of a pair, seen from the other.
  struct Side {
    int face, pair;
    double weight;
    bool isFirst;  // the pair's difference leads away from it
  };

  Quaternion startOf(const Positions& positions, int face) const;
  Quaternion agreeing(int face, const Scratch& scratch) const;
  FaceDeformation deformationIn(const Positions& positions, int face) const;

  const WeldedKeys* keys_;
  const LriSpace* lri_;
  std::vector<int> used_;            // faces that have area
  std::vector<FaceFrame> frame_;     // of each face
  std::vector<int> slotOf_;          // of each face
  CompressedRows<Side> neighbours_;  // of each face; none without area
  RotationPaths<double> differences_;
  int pairs_ = 0;
};

}  // namespace shapespline
