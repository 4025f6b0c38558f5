// Keys that are a mirror image of the others: no motion leads there.
#pragma once

#include <vector>

#include "core/lri/welded_shape.h"

namespace shapespline {

/// How similarly a surface bulges in two keys, in [-1, 1]; 1 if undecided, as on a sheet, which may roll up either way.
/// A vertex where the surface is dome-shaped bulges to the same side of its faces in every pose; in a mirror image it
/// bulges to the other.
double bulgeAgreement(const WeldedShape& shape, int key, int otherKey);

/// The keys in which the surface is a mirror image of what it is in the other keys, ascending; at most half of the
/// keys.
std::vector<int> mirroredKeys(const WeldedShape& shape);

}  // namespace shapespline
