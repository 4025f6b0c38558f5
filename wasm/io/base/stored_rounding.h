// Estimates rounding of stored single-precision positions.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// Largest possible displacement by rounding to float: half a unit in the last place of the largest coordinate, along
/// each axis. 0 if a coordinate is not a float, because the file then stores higher precision.
double storedRounding(const Positions& positions);

}  // namespace shapespline
