// Where the supernode tree is cut so that two can work on it.
#pragma once

#include <vector>

#include "core/sparse/symbolic.h"

namespace shapespline {

/// What lies above both parts and comes after them.
inline constexpr int topPart = 2;

/// The part of each supernode: 0 and 1 are whole subtrees of about the same work, which have no column in common and
/// only rows in the top, 2, which is as little as can be.
std::vector<int> cutTree(const SymbolicFactor& symbolic);

}  // namespace shapespline
