// The metric of spaces in which rotations move through the keys by themselves, of faces or of pairs of them.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/reconstruct/rotation_paths.h"
#include "core/space/lri_space.h"

namespace shapespline {

/// The share of each face in the area of the reference pose, by its slot; 0 without area.
std::vector<double> areaShares(const WeldedKeys& keys, const LriSpace& lri);

/// Inner products of the columns: sums of the paths' increments, each path with its weight, and the rest as in LRI
/// space (gram_matrix.h): stretches of faces by their share of the area, mean positions over the diagonal. weight: by
/// slot; slots of weight 0 take no part.
template <class Real>
Eigen::MatrixXd pathGram(const WeldedKeys& keys, const LriSpace& lri, const RotationPaths<Real>& paths,
                         const std::vector<double>& weight);

}  // namespace shapespline
