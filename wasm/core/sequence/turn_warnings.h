// Warnings about ambiguous rotations.
#pragma once

#include <vector>

#include "core/base/warning.h"
#include "core/lri/lri.h"
#include "core/patches/patch_motion.h"
#include "core/sequence/options.h"

namespace shapespline {

/// One warning per interval and kind: the whole, a component, neighbouring patches, faces. None of what whole turns
/// were added to (turns: components as patches count them). A closed curve has an interval from the last key to the
/// first. Of an open one also where regions turn so far beyond the keys that noise in the keys decides. Warning::face
/// is a face of the welded mesh.
std::vector<Warning> turnWarnings(const WeldedShape& shape, const PatchMotion& patches,
                                  const std::vector<AmbiguousFaces>& faces, const std::vector<int>& patchOfFace,
                                  const std::vector<AddedTurns>& turns, const Curve& curve);

}  // namespace shapespline
