// The weights of a curve's columns, taken to the poses that were encoded.
#pragma once

#include <vector>

#include "core/spline.h"
#include "core/types.h"
#include "core/welded_shape.h"

namespace shapespline {

/// Weights over the poses that were encoded.
struct PoseWeights {
  std::vector<double> column;  ///< one a column of the coordinates; the closing weight is counted in the first key's
  double closing = 0;          ///< that weight, for the numbers that wind
  int keys = 0;                ///< columns that are keys: the first so many
  int beyond = -1;             ///< end key that the curve goes on from beyond the keys, or -1 within them
};

/// Weights that no sum in double precision can show are 0.
PoseWeights poseWeights(const Weights& weights, const WeldedShape& shape);

/// Weighted sum of one vector a column.
Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights);

}  // namespace shapespline
