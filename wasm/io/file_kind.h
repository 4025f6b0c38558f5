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

/// Whether a file only accompanies mesh files: buffers, images, OBJ materials, read-me files.
/// A text file with the content of a mesh is a mesh.
bool isCompanion(const NamedBytes& file);

/// Whether the name suggests a mesh or its motion.
bool isMeshName(std::string_view name);

/// Completes a warning about a file whose name ends in the extension of another format; empty if it fits.
std::string otherExtension(std::string_view name, FileKind kind);

/// Errors: EmptyFile; NotRecognised with a guess (a web page, an archive, another 3D format).
Result<FileKind> fileKind(const NamedBytes& file, const std::string& where);

}  // namespace shapespline
