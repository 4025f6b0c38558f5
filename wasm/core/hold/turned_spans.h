// Spans with added full turns are not held: their targets do not turn.
#pragma once

#include <vector>

#include "core/spline/rotation_spline.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Share of holding in each span, in [0, 1]: 0 in spans with added turns, and in neighbouring spans where the rotation
/// spline overshoots far because of them. Empty without turns.
std::vector<double> heldShares(const Curve& curve, const std::vector<AddedTurns>& turns);

}  // namespace shapespline
