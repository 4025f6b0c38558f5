// Rotations that go over into others where the two agree.
#pragma once

#include "core/base/fork_join.h"
#include "core/reconstruct/rotation_blocks.h"

namespace shapespline {

/// With q = own rotation^-1, rotation becomes exp(2 q.w |q.w|^4 q.vec) rotation: `own` to the third order of what they
/// differ by, nothing of it where that is half a turn. No logarithm, so no branch, and smooth everywhere.
template <class Real>
void fadeRotations(const RotationBlocks<Real>& own, RotationBlocks<Real>& rotation, ForkJoin* forkJoin = nullptr);

}  // namespace shapespline
