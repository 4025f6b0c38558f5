// Imports several files, one key each.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/base/source_files.h"
#include "io/pose_reader.h"

namespace shapespline {

/// Display name of a key's file: the `key`th of `keys`. Warnings of its reader name the first file without a number,
/// because users can renumber keys.
std::string placeName(const NamedBytes& file, int key, std::size_t keys);

/// Name of a key: the file name without folders and extension.
std::string keyName(const NamedBytes& file);

bool areAll(const std::vector<MeshFile>& meshes, FileKind kind);

/// Sets the error's key.
Error atKey(Error error, int key);

/// Adds a pose as a key. The first pose provides the mesh and the scene. `where`: display name of its file.
/// Errors: as KeyJoiner::add, naming the objects if they differ from the first pose's.
Status addPose(PoseFile&& pose, std::string name, Import& out, const std::string& where);

/// Warns if keys seem to be Z up, the format does not state its up axis, and the user chose none. `writtenZUp`: the
/// first file states Z.
void hintAtUpAxis(FileKind kind, bool writtenZUp, const ImportOptions& options, const std::string& where,
                  Import& import);

/// Poses store no times, so they are placed one second apart.
void setTimesInSeconds(Keyframes& keyframes);

/// Reads one key per file, in file order. If files have different objects (such as a ground plane), the keys use the
/// objects that all files share, with a warning. Errors: those of the readers, and of files that do not match.
Result<Import> importPoses(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                           const StageProgress& progress);

}  // namespace shapespline
