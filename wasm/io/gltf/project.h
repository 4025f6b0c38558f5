// The saved project inside an exported GLB: extras.shapespline of the root object.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"

namespace shapespline {

/// One key of a saved project: a frame of the exported mesh, or else a time of its animation.
struct ProjectKey {
  std::string name;
  double time = 0;     ///< in the user's unit
  int frame = -1;      ///< 0: the mesh's base; k: morph target k - 1 alone, at weight 1; -1: see seconds
  double seconds = 0;  ///< on the animation's own timeline
};

/// The part of the project that import needs; the rest of the JSON (options) is handed on as it came.
struct Project {
  std::vector<ProjectKey> keys;  ///< two or more, times increasing
  Vec3 offset = Vec3::Zero();    ///< that its shapes were computed relative to (io/far_offset.h); finite
};

/// Reads {"keys": {"times": [...], "names": [...], "frames": [...], "seconds": [...]}, "offset": [x, y, z], ...}: lists
/// of one length. Names and the offset may be missing, and either frames or seconds. Error: MalformedFile with a
/// sentence that works as a warning.
Result<Project> parseProject(const std::string& json, int morphTargets, bool animated);

}  // namespace shapespline
