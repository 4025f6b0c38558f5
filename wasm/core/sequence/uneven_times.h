// Keys so unevenly spaced in time that the spline carries the shape far away from them.
#pragma once

#include <functional>
#include <vector>

#include "core/base/status.h"
#include "core/base/warning.h"
#include "core/sequence/motion.h"

namespace shapespline {

/// Warns where the motion leaves the box around the keys by more than the box's diagonal: between two keys of which the
/// interval is much longer than a neighbouring one, and one mean interval beyond the ends. The weights of the curve say
/// where that may be; only there `shapeAt` is asked for the shape, so evenly spaced keys cost nothing.
std::vector<Warning> unevenTimesWarnings(const EncodedShape& encoded, const Motion& motion,
                                         const std::function<Status(double t, Positions& shape)>& shapeAt);

}  // namespace shapespline
