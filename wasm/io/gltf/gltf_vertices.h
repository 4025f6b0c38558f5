// Restores the vertices of the mesh. A glTF file has more: it splits vertices at texture seams, and every primitive has
// its own. Our files state the mesh vertex of each of their vertices.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/gltf_shape.h"

namespace shapespline {

/// A number for each vertex of a primitive: the vertex of the mesh that it is, or is a copy of. A float holds them
/// exactly up to 16.7 million, which is more than mostElements.
inline constexpr std::string_view vertexAttribute = "_SHAPESPLINE_VERTEX";

/// With seams: the number of the drawn vertex. Without this attribute, the first file vertex of a mesh vertex is drawn
/// as the vertex, others are copies.
inline constexpr std::string_view drawnAttribute = "_SHAPESPLINE_DRAWN";

/// Puts the mesh together again: poses, normals, faces and scene get the vertices that the file's numbers say, in their
/// order, and the scene its seams. Numbers that other programs have left out leave no gaps. Nothing happens where a
/// primitive has no numbers, or where vertices of one number do not stand at one place in every pose.
void joinVertices(const GltfDocument& doc, const GltfShape& shape, const std::vector<Positions*>& poses,
                  Positions& normals, std::vector<Triangle>& faces, Scene& scene);

}  // namespace shapespline
