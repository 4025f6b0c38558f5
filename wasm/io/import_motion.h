// Files that hold a motion: keys are sampled from it.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "io/base/given_files.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/numbered_files.h"
#include "io/pose_reader.h"

namespace shapespline {

/// Several glTF files with an animation each: the keys of one after those of the other. Exporters write a rig's whole
/// animation into every file, which counts once, with a warning. Errors: of the readers, and of files that are not of
/// one mesh.
Result<Import> importAnimations(const std::vector<MeshFile>& meshes, const GivenFiles& files, ImportOptions options,
                                const StageProgress& progress);

/// The frames of a numbered series of files, each read when it is asked for. Errors: as above.
Result<Import> importSeries(const std::vector<MeshFile>& meshes, const NumberedFiles& series, const GivenFiles& files,
                            const ImportOptions& options, const StageProgress& progress);

/// A mesh, and its vertices over time in a PC2 or MDD file. Errors: of the readers, and VertexCountMismatch.
Result<Import> importCache(const MeshFile& mesh, const MeshFile& moves, const GivenFiles& files,
                           const ImportOptions& options, const StageProgress& progress);

}  // namespace shapespline
