// Bytes of one or several files -> keyframes and the scene around them. The only entrance for files.
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"

namespace shapespline {

/// Reads keys from files: several files with one pose each (keys in the order given), or one file with morph targets or
/// an animation. Buffers and images of a file are looked up among the files. A saved project (export.h) becomes its
/// keys again, unless an animation or samples are requested. `progress` receives stages, with a fraction of the whole
/// in [0, 1] that never decreases. Errors: every ErrorCode of reading, and of keys that do not match; the message names
/// file, key and place.
Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress = {});

}  // namespace shapespline
