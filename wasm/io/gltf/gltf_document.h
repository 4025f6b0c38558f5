// A glTF file with verified JSON, version, extensions, buffers and images.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/warning.h"
#include "io/base/named_bytes.h"
#include "io/base/scene.h"
#include "io/base/source_files.h"
#include "io/base/uri.h"
#include "io/gltf/tinygltf.h"

namespace shapespline {

/// tinygltf only provides the JSON types. Buffers and images are resolved here, because tinygltf copies, guesses and
/// opens files without our checks. `model.buffers` and `model.images` are therefore empty.
struct GltfDocument {
  std::string where;  ///< display name of the file
  tinygltf::Model model;
  std::vector<Resource> buffers;  ///< byteLength bytes each, or empty for a placeholder
  std::uint64_t bufferBytes = 0;  ///< total size of all buffers
  std::uint64_t fileBytes = 0;    ///< total size of the JSON and the buffers, each counted once
  std::vector<Image> images;      ///< available images, each once
  std::vector<int> imageOf;       ///< index into `images` for each image of the file, or -1
  std::string project;            ///< JSON of extras.shapespline, or empty
  std::vector<Warning> warnings;
};

/// Why a part of the file cannot be read, as the rest of a sentence; empty for a sound part. `extras`: of this part.
/// Such a part is empty, and an error only where it is used.
std::string brokenPart(const tinygltf::Value& extras);

/// Opens a .glb (detected by its magic number) or .gltf file. Errors: all reading errors of ErrorCode.
Result<GltfDocument> openGltf(const NamedBytes& file, const SourceFiles& files, const std::string& where);

}  // namespace shapespline
