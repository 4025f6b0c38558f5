// Computes only the elimination order. It is independent of the encoding, so both can run at the same time.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"

namespace shapespline {

/// The order in which EncodedShape::build eliminates the unknowns for these keys (reconstruct/poisson.h): order[p] is
/// the unknown at position p. Errors: as for EncodedShape::build.
Result<std::vector<int>> eliminationOrder(Keyframes keyframes, const EncodingOptions& options);

}  // namespace shapespline
