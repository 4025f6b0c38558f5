// Morph targets of several meshes as one list: matched by name if the files have names, otherwise by index.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace shapespline {

struct JoinedTargets {
  std::vector<std::string> names;       ///< of the joined targets; generated if missing
  std::vector<std::vector<int>> slots;  ///< of each mesh, of each of its targets: the joined one

  int count() const { return static_cast<int>(names.size()); }
};

/// The targets of the meshes that these nodes show. Targets with one name (extras.targetNames) are joined; targets
/// without a name are joined by index. A mesh without a target does not move with it.
JoinedTargets joinTargets(const GltfDocument& doc, const std::vector<int>& meshNodes);

}  // namespace shapespline
