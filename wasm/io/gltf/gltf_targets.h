// Joins morph targets of several meshes into one list: matched by name if the files have names, otherwise by index.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace shapespline {

struct JoinedTargets {
  std::vector<std::string> names;       ///< names of the joined targets, generated if missing
  std::vector<std::vector<int>> slots;  ///< joined target for each mesh and each of its targets

  int count() const { return static_cast<int>(names.size()); }
};

/// Joins the targets of the meshes of these nodes: by name, or by index for targets without a name. Names are in
/// extras.targetNames of the mesh or of its primitives, or else are those of the accessors. A joined target does not
/// move meshes that lack it.
JoinedTargets joinTargets(const GltfDocument& doc, const std::vector<int>& meshNodes);

}  // namespace shapespline
