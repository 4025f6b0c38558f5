// The saved project inside an exported GLB: extras.shapespline of the root object.
#pragma once

#include <string>
#include <vector>

#include "core/status.h"

namespace shapespline {

/// One key of a saved project.
struct ProjectKey {
  std::string name;
  double time = 0;
  int frame = 0;  ///< 0: the mesh's base; k: morph target k - 1 alone, at weight 1
};

/// The part of the project that import needs; the rest of the JSON (options) is handed on as it came.
struct Project {
  std::vector<ProjectKey> keys;  ///< two or more, times increasing
};

/// Reads {"keys": [{"name": "...", "time": 0.4, "frame": 12}, ...], ...}.
/// Error: MalformedFile with a sentence that works as a warning.
Result<Project> parseProject(const std::string& json, int morphTargets);

}  // namespace shapespline
