// Warns about unevenly spaced keys that carry the spline far away from the shapes.
#pragma once

#include <functional>
#include <vector>

#include "core/base/status.h"
#include "core/base/warning.h"
#include "core/sequence/motion.h"

namespace shapespline {

/// Warns if patches rotate, or edge lengths change, far past the keys: between two keys whose interval is much longer
/// than a neighbouring one, or one mean interval beyond an end whose interval is much shorter than the mean. The
/// curve's weights show candidate times. `shapeAt` is called only for these, so evenly spaced keys cost nothing.
std::vector<Warning> unevenTimesWarnings(const EncodedShape& encoded, const Motion& motion,
                                         const std::function<void(double t, Positions& shape)>& shapeAt);

}  // namespace shapespline
