// Several files, each of which is a key.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/base/given_files.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/pose_reader.h"

namespace shapespline {

/// How messages call a key's file, the `key`th of `keys`.
std::string placeName(const NamedBytes& file, int key, std::size_t keys);

/// A key's name: the file's, without folders and ending.
std::string keyName(const NamedBytes& file);

bool areAll(const std::vector<MeshFile>& meshes, FileKind kind);

/// The error as one of this key.
Error atKey(Error error, int key);

/// Adds a pose as a key; the first one brings the mesh and the scene. `where` is how messages call its file.
/// Errors: as KeyJoiner::add, with the objects where the pose has others than the first one.
Status addPose(PoseFile&& pose, std::string name, Import& out, const std::string& where);

/// Warns if keys of a format that does not state its up axis seem to be Z up, and no axis was chosen. `writtenZUp`: the
/// first file states Z.
void hintAtUpAxis(FileKind kind, bool writtenZUp, const ImportOptions& options, const std::string& where,
                  Import& import);

/// Poses have no times, so they are one second apart.
void setTimesInSeconds(Keyframes& keyframes);

/// Files -> keys, in their order. If files have different objects (such as a ground plane), the keys use the objects
/// that all files share, with a warning. Errors: of the readers, and of files that do not match.
Result<Import> importPoses(const std::vector<MeshFile>& meshes, const GivenFiles& files, const ImportOptions& options,
                           const StageProgress& progress);

}  // namespace shapespline
