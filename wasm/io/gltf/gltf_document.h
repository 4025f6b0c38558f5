// A glTF file whose outer shell has been checked: JSON, version, extensions, buffers, images.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/warning.h"
#include "io/base/given_files.h"
#include "io/base/named_bytes.h"
#include "io/base/scene.h"
#include "io/base/uri.h"
#include "io/gltf/tinygltf.h"

namespace shapespline {

/// tinygltf gives the JSON types; buffers and images are resolved here, because tinygltf copies, guesses and opens
/// where we must check. `model.buffers` and `model.images` are therefore empty.
struct GltfDocument {
  std::string where;  ///< how messages call the file
  tinygltf::Model model;
  std::vector<Resource> buffers;  ///< byteLength bytes each, or none for a placeholder
  std::uint64_t bufferBytes = 0;  ///< of all buffers together
  std::uint64_t fileBytes = 0;    ///< of all that was given for it: its JSON and buffers, each once
  std::vector<Image> images;      ///< those that could be had, each once
  std::vector<int> imageOf;       ///< of the file's images: place in `images`, or -1
  std::string project;            ///< JSON of extras.shapespline, or empty
  std::vector<Warning> warnings;
};

/// Opens .glb (recognised by its magic) or .gltf. Errors: all of reading; see ErrorCode.
Result<GltfDocument> openGltf(const NamedBytes& file, const GivenFiles& files, const std::string& where);

}  // namespace shapespline
