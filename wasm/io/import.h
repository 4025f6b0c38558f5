// Reads keyframes and their scene from the bytes of one or several files. The only public header for reading.
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"

namespace shapespline {

/// Reads keys from several files with one pose each (keys in the given order), or from one file with morph targets or
/// an animation. Buffers and images are searched among the files. A saved project (export.h) restores its keys, unless
/// an animation or samples are requested. `progress` receives stages, with a fraction of the total in [0, 1] that never
/// decreases. Errors: every ErrorCode of reading, and of keys that do not match. The message names file, key and
/// position.
Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress = {});

}  // namespace shapespline
