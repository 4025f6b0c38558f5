// Morph targets of several meshes as one list: by name where the files say which belong together, else by place.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace shapespline {

struct JoinedTargets {
  std::vector<std::string> names;       ///< of the joined targets; made up where there is none
  std::vector<std::vector<int>> slots;  ///< of each mesh, of each of its targets: the joined one

  int count() const { return static_cast<int>(names.size()); }
};

/// Those of the meshes that these nodes show. Named targets (extras.targetNames) of one name are one; targets without
/// a name go by their index. A mesh without a target does not move with it.
JoinedTargets joinTargets(const GltfDocument& doc, const std::vector<int>& meshNodes);

}  // namespace shapespline
