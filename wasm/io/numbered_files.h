// Whether files are the frames of one animation, as their names say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/pose_reader.h"

namespace shapespline {

struct NumberedFiles {
  std::string name;             ///< what their names have in common
  std::vector<double> seconds;  ///< of each file, from 0, at kFramesPerSecond
};

/// OBJ or PLY files, two at least and all of one kind, whose names differ in the number before the extension alone, in
/// increasing order: walk0001.obj, walk0002.obj. Nothing where they are none. Numbers may be negative; whether a hyphen
/// is a sign, all names together say. web/engine/api/numbered-names.ts has the same rule for the order of files; both
/// pass tests/numbered-names.json.
std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes);

/// The names of several numbered sequences that lie among the files, with their counts; empty where there is one at
/// most.
std::string sequencesAmong(const std::vector<MeshFile>& meshes);

}  // namespace shapespline
