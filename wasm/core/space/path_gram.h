// The metric of spaces with separate rotation paths, of faces or of pairs of faces.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// Share of each face in the area of the reference pose, by slot; 0 without area.
std::vector<double> areaShares(const WeldedKeys& keys, const LriSpace& lri);

/// Inner products of the columns: weighted sums of the paths' increments, and stretches and mean positions as in LRI
/// space (gram_matrix.h). weight: one per path, by slot; slots of weight 0 are ignored.
template <class Real>
Eigen::MatrixXd pathGram(const WeldedKeys& keys, const LriSpace& lri, const RotationPaths<Real>& paths,
                         const std::vector<double>& weight);

}  // namespace shapespline
