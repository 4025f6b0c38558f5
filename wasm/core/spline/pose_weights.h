// The weights of a curve's columns, taken to the poses that were encoded.
#pragma once

#include <vector>

#include "core/spline/spline.h"
#include "core/base/types.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// Weights over the poses that were encoded.
struct PoseWeights {
  std::vector<double> column;  ///< one per column of the coordinates
  int keys = 0;                ///< columns that are keys: the first so many
  int beyond = -1;             ///< end key that the curve goes on from beyond the keys, or -1 within them
};

/// Weights that no sum in double precision can show are 0.
PoseWeights poseWeights(const CurvePoint& point, const WeldedShape& shape);

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights);

}  // namespace shapespline
