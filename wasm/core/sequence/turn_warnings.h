// Warnings about ambiguous rotations.
#pragma once

#include <vector>

#include "core/base/warning.h"
#include "core/lri/lri.h"
#include "core/patches/patch_motion.h"
#include "core/sequence/options.h"

namespace shapespline {

/// One warning per interval and kind: the whole, a component, neighbouring patches, faces. Omits parts with added
/// turns. turns: components are numbered as in the patches. closes: whether to include the interval from the last key
/// to the first. Warning::face is a face of the welded mesh.
std::vector<Warning> turnWarnings(const WeldedShape& shape, const PatchMotion& patches,
                                  const std::vector<AmbiguousFaces>& faces, const std::vector<int>& patchOfFace,
                                  const std::vector<AddedTurns>& turns, bool closes);

}  // namespace shapespline
