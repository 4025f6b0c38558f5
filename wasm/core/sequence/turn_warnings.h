// Warnings about ambiguous rotations.
#pragma once

#include <vector>

#include "core/base/warning.h"
#include "core/lri/lri.h"
#include "core/patches/patch_motion.h"
#include "core/sequence/options.h"

namespace shapespline {

/// One warning per interval and kind: the whole shape, a component, neighbouring patches, faces. No warning for
/// components to which full turns were added. For an open curve, also a warning if rotations beyond the keys are so
/// large that noise in the keys determines them. A closed curve has an interval from the last key to the first. turns:
/// components are numbered as in the patches. Warning::face is a face of the welded mesh.
std::vector<Warning> turnWarnings(const WeldedShape& shape, const PatchMotion& patches,
                                  const std::vector<AmbiguousFaces>& faces, const std::vector<int>& patchOfFace,
                                  const std::vector<AddedTurns>& turns, const Curve& curve);

}  // namespace shapespline
