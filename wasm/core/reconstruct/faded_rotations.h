// Blends rotations into others where both agree.
#pragma once

#include "core/base/fork_join.h"
#include "core/reconstruct/rotation_blocks.h"

namespace shapespline {

/// With q = own rotation^-1, rotation becomes exp(2 q.w |q.w|^4 q.vec) rotation. The result is `own` up to third order
/// in their difference, and unchanged if they differ by half a turn. Needs no logarithm, so it has no branches and is
/// smooth everywhere.
template <class Real>
void fadeRotations(const RotationBlocks<Real>& own, RotationBlocks<Real>& rotation, ForkJoin* forkJoin = nullptr);

}  // namespace shapespline
