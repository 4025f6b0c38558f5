// Measures of shapes.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Signed volume enclosed by the faces (divergence theorem). Correct for closed, consistently wound meshes.
double enclosedVolume(const Positions& positions, const std::vector<Triangle>& faces);
double surfaceArea(const Positions& positions, const std::vector<Triangle>& faces);

}  // namespace shapespline
