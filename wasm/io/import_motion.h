// Samples keys from files that store a motion.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/base/source_files.h"
#include "io/numbered_files.h"
#include "io/pose_reader.h"

namespace shapespline {

/// Reads several glTF files with an animation each and appends their keys in file order. Some exporters write a rig's
/// whole animation into every file: duplicates are dropped with a warning. Errors: those of the readers, and of files
/// with different meshes.
Result<Import> importAnimations(const std::vector<MeshFile>& meshes, const SourceFiles& files, ImportOptions options,
                                const StageProgress& progress);

/// Reads the frames of a numbered series of files, each file on demand. Errors: as above.
Result<Import> importSeries(const NumberedFiles& series, const SourceFiles& files, const ImportOptions& options,
                            const StageProgress& progress);

/// Reads a mesh, and its vertices over time from a PC2 or MDD file. Errors: those of the readers, and
/// VertexCountMismatch.
Result<Import> importCache(const MeshFile& mesh, const MeshFile& moves, const SourceFiles& files,
                           const ImportOptions& options, const StageProgress& progress);

}  // namespace shapespline
