// Detects the kind of a file from its first bytes, or from its name if the bytes are ambiguous.
#pragma once

#include <string>
#include <string_view>

#include "core/base/status.h"
#include "io/base/named_bytes.h"

namespace shapespline {

enum class FileKind { Gltf, Obj, Ply, Off, Pc2, Mdd };

/// Whether files of this kind store a motion for another file's mesh.
constexpr bool isCache(FileKind kind) { return kind == FileKind::Pc2 || kind == FileKind::Mdd; }

/// Whether a file with this name only accompanies mesh files: buffers, images, OBJ materials, read-me files.
bool isCompanion(std::string_view name);

/// Whether the name suggests a mesh or its motion.
bool isMeshName(std::string_view name);

/// Errors: EmptyFile; NotRecognised with a guess (a web page, an archive, another 3D format).
Result<FileKind> fileKind(const NamedBytes& file, const std::string& where);

}  // namespace shapespline
