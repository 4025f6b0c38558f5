// The saved project inside an exported GLB: extras.shapespline of the root object.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"

namespace shapespline {

/// One key of a saved project: a frame of the exported mesh, or a time of its animation.
struct ProjectKey {
  std::string name;
  double time = 0;     ///< in the user's time unit
  int frame = -1;      ///< 0: the base; k: morph target k - 1 alone, at weight 1; -1: see seconds
  double seconds = 0;  ///< on the animation's timeline
};

/// The part of the project needed by import. The rest of the JSON (options) is passed on unchanged.
struct Project {
  std::vector<ProjectKey> keys;  ///< two or more keys with increasing times
  Vec3 offset = Vec3::Zero();    ///< offset used when the shapes were computed (io/far_offset.h); finite
};

/// Reads {"keys": {"times": [...], "names": [...], "frames": [...], "seconds": [...]}, "offset": [x, y, z], ...} with
/// lists of equal length. Names, the offset, and one of frames or seconds may be missing. Error: MalformedFile with a
/// message that also works as a warning.
Result<Project> parseProject(const std::string& json, int morphTargets, bool animated);

}  // namespace shapespline
