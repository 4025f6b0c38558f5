// One mesh file -> one pose.
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "io/base/given_files.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/file_kind.h"
#include "io/gltf/gltf_reader.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// A file and its kind.
struct MeshFile {
  const NamedBytes* file;
  FileKind kind;
};

/// Y up, in metres, whatever the file's axes and unit.
void orient(Positions& positions, bool zUp, double scale);

/// Reads one pose after the other; polygons are cut as in the first one that has any.
struct PoseReader {
  const GivenFiles& files;
  const ImportOptions& options;
  std::optional<PolygonCuts> cuts{};

  Result<PoseFile> read(const MeshFile& mesh, const std::string& where, const FractionReport& onProgress = {});
};

}  // namespace shapespline
