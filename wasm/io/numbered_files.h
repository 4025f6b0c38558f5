// Detects by name whether files are frames of one animation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/pose_reader.h"

namespace shapespline {

struct NumberedFiles {
  std::string name;              ///< common start of the file names
  std::vector<MeshFile> meshes;  ///< in the order of their numbers
  std::vector<double> seconds;   ///< time of each file, starting at 0, at framesPerSecond
};

/// Recognises two or more OBJ or PLY files of one kind, in any order, whose names differ only in one number:
/// walk0001.obj, walk0002.obj, or walk (1).obj. Numbers may be negative: all names together decide whether a hyphen is
/// a sign. web/engine/api/numbered-names.ts orders files by the same rule; both pass
/// tests/numbered-names.json.
std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes);

/// Lists names and counts if the files contain several numbered sequences, else empty.
std::string sequencesAmong(const std::vector<MeshFile>& meshes);

}  // namespace shapespline
