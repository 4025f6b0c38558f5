// Checks that a shape can be written.
#pragma once

#include <span>

#include "core/base/status.h"

namespace shapespline {

/// `frame`: index in a motion, or -1. Error: NotFinite with the frame as `key`, and the vertex.
Status checkFinite(std::span<const float> positions, int frame);

}  // namespace shapespline
