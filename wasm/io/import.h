// Bytes of one or several files -> keyframes and the scene around them. The only entrance for files.
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"

namespace shapespline {

/// Reads keys from files: several files with one pose each (keys in the order given), or one with morph targets or an
/// animation. Buffers and images that a file names are looked up among the files. What a saved project holds
/// (export.h) becomes its keys again, unless an animation or samples are asked for. `progress` hears the stages with a
/// fraction of the whole in [0, 1] that never falls.
/// Errors: every ErrorCode of reading and of keys that do not fit; the message names file, key and place.
Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress = {});

}  // namespace shapespline
