// Cuts the supernode tree for two threads.
#pragma once

#include <vector>

#include "core/sparse/symbolic.h"

namespace shapespline {

/// Marks supernodes above both parts, which come last.
inline constexpr int topPart = 2;

/// The part of each supernode. Parts 0 and 1 are whole subtrees with about the same work. They share no columns, and
/// share rows only in the top, part 2, which is as small as possible.
std::vector<int> cutTree(const SymbolicFactor& symbolic);

}  // namespace shapespline
