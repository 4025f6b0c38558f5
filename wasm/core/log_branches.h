// Which representative of a logarithm stands in the coordinates: the one nearest the pose before, so that a part may turn
// far and every key stays exact.
#pragma once

#include <vector>

#include "core/types.h"
#include "core/welded_shape.h"

namespace shapespline {

/// Appends the logarithm of the next column's rotation, as the representative nearest that of the pose before it.
void appendNearest(std::vector<Vec3>& columns, const WeldedShape& shape, const Vec3& rotationVector);

/// A number of the coordinates that does not return to itself after one period: its closing representative minus the
/// first key's.
struct Winding {
  int index;  ///< face or pair
  Vec3 difference;
};

/// Adds a winding where the representative of `first` nearest `last` is another one.
void addWinding(std::vector<Winding>& windings, int index, const Vec3& first, const Vec3& last);

}  // namespace shapespline
