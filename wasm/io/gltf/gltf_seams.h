// A mesh whose texture has seams, in a format that knows none: glTF splits its vertices. Ours say which are copies.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/gltf_shape.h"

namespace shapespline {

/// A number for each drawn vertex: the vertex of the mesh that it is, or is a copy of. A float holds them exactly up to
/// 16.7 million, which is more than kMostElements.
inline constexpr std::string_view kVertexAttribute = "_SHAPESPLINE_VERTEX";

/// Puts a mesh together again that was exported with copies: poses, normals, faces and scene lose them, and the scene
/// gets its seams. Nothing happens where the file holds no such attribute, or other tools have changed what it says.
void joinSeams(const GltfDocument& doc, const GltfShape& shape, const std::vector<Positions*>& poses,
               Positions& normals, std::vector<Triangle>& faces, Scene& scene);

}  // namespace shapespline
