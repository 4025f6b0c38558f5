// Detects by name whether files are the frames of one animation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/pose_reader.h"

namespace shapespline {

struct NumberedFiles {
  std::string name;             ///< common start of their names
  std::vector<double> seconds;  ///< of each file, from 0, at framesPerSecond
};

/// At least two OBJ or PLY files of one kind, whose names differ only in the number before the extension, in increasing
/// order: walk0001.obj, walk0002.obj. Nothing otherwise. Numbers may be negative: all names together decide whether a
/// hyphen is a sign. web/engine/api/numbered-names.ts orders files by the same rule; both pass
/// tests/numbered-names.json.
std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes);

/// Names and counts of several numbered sequences among the files; empty for fewer than two.
std::string sequencesAmong(const std::vector<MeshFile>& meshes);

}  // namespace shapespline
