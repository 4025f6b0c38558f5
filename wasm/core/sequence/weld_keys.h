// Converts keyframes to welded keys.
#pragma once

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "core/space/welded_keys.h"

namespace shapespline {

/// keyframes: poses are freed after welding. Errors: those of validate(), InvalidOption, and VertexCountMismatch and
/// NotFinite for tangent poses.
Result<WeldedKeys> weldKeys(Keyframes keyframes, const EncodingOptions& options, const FractionReport& onProgress = {});

}  // namespace shapespline
