// The order of elimination alone. Nothing of the encoding needs it, nor does it need anything of that, so both can be
// made at the same time.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"

namespace shapespline {

/// The order in which EncodedShape::build eliminates the unknowns of the same keys (reconstruct/poisson.h): order[p] is
/// the one at position p. Errors: as there.
Result<std::vector<int>> eliminationOrder(Keyframes keyframes, const EncodingOptions& options);

}  // namespace shapespline
