// Reads one pose from one mesh file.
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/base/source_files.h"
#include "io/file_kind.h"
#include "io/gltf/gltf_reader.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// A file and its kind.
struct MeshFile {
  const NamedBytes* file;
  FileKind kind;
};

/// Converts positions to Y up and metres.
void orient(Positions& positions, bool zUp, double scale);

/// Reads poses one by one. Polygons are cut as in the first pose with polygons.
struct PoseReader {
  const SourceFiles& files;
  const ImportOptions& options;
  std::optional<PolygonCuts> cuts{};

  Result<PoseFile> read(const MeshFile& mesh, const std::string& where, const FractionReport& onProgress = {});
};

}  // namespace shapespline
