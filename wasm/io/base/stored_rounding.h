// How far positions may have been moved when a program stored them in single precision.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// Half a step of the last bit, along all axes, at the largest coordinate that uses it; 0 where some coordinate is no
/// number of single precision: then they were stored in another way.
double storedRounding(const Positions& positions);

}  // namespace shapespline
