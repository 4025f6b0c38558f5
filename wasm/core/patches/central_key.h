// The key that represents all keys of a shape. Patches and their frames are found from rotations relative to it, so
// they depend neither on the reference pose nor on the order of the keys.
#pragma once

#include "core/lri/welded_shape.h"

namespace shapespline {

/// The key with the least mean square rotation to all keys, over the faces. Among keys that are equally central, such
/// as two keys, the one with the larger area; among those of equal area, the one nearest to the reference pose. Visits
/// at most 500 faces.
int centralKey(const WeldedShape& shape, const ShapeTopology& topology);

}  // namespace shapespline
