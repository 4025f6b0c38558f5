// Detects keys that are mirror images of the others. No motion leads to a mirror image.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"

namespace shapespline {

/// Similarity of a surface's bulges in two keys, in [-1, 1]; 1 if undecided, as for a sheet, which may roll up either
/// way. A vertex where the surface is dome-shaped bulges to the same side of its faces in every pose, and to the other
/// side in a mirror image.
double bulgeAgreement(const WeldedShape& shape, int key, int otherKey);

/// Keys whose surface is a mirror image of that in the other keys, ascending; at most half of the keys.
std::vector<int> mirroredKeys(const WeldedShape& shape);

}  // namespace shapespline
