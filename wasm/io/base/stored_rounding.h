// How far positions may have been moved when a program stored them in single precision.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// Half a step of the last bit along all axes, at the largest coordinate. 0 if a coordinate is not a single-precision
/// number: then the file did not store single precision.
double storedRounding(const Positions& positions);

}  // namespace shapespline
