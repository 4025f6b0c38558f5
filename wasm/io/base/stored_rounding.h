// How far positions may have been moved when a program stored them in single precision.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// The largest distance by which rounding to float may have moved a position: along each axis half a unit in the last
/// place of the largest coordinate. 0 if a coordinate is no float: then the file did not store single precision.
double storedRounding(const Positions& positions);

}  // namespace shapespline
