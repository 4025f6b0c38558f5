// How a shape changes with the timing of the intervals around its time: for fits of timings to an animation.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/motion.h"

namespace shapespline {

struct TimingDerivatives {
  std::vector<int> intervals;  ///< those whose timing has an effect at the time, at most three
  /// For each of these intervals and both of its numbers, earlier and swing: the derivative of the shape by the number
  /// of each region, and then by that of the position. 3n floats each, xyz interleaved.
  std::vector<float> shapes;
};

/// One-sided differences at the timing of the whole of a motion in LRI space; its regions are left out. To first order,
/// the frames of patches stay with the mean, as for regions. regionOf: the region of each patch, numbered from 0.
/// Errors: InvalidOption (another method, a ghost mesh, another number of patches, a time beyond the keys).
Result<TimingDerivatives> timingDerivatives(const EncodedShape& encoded, const Motion& motion, double t,
                                            const std::vector<int>& regionOf);

}  // namespace shapespline
