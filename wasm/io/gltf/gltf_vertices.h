// Restores the mesh's vertices. A glTF file has more: it splits vertices at texture seams, and every primitive has its
// own. Our files store the mesh vertex of each of their vertices.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/gltf_shape.h"

namespace shapespline {

/// Attribute with the mesh vertex of each vertex of a primitive. A float is exact up to 16.7 million, which exceeds
/// maxElements.
inline constexpr std::string_view vertexAttribute = "_SHAPESPLINE_VERTEX";

/// Attribute with the drawn vertex, for files with seams. Without it, the first file vertex of a mesh vertex is drawn
/// as that vertex, and others become copies.
inline constexpr std::string_view drawnAttribute = "_SHAPESPLINE_DRAWN";

/// Reassembles the mesh: poses, normals, faces and scene get the vertices numbered in the file, in order, and the scene
/// gets its seams. Numbers removed by other programs leave no gaps. Does nothing if a primitive has no numbers, or if
/// vertices with equal numbers have different positions in a pose.
void joinVertices(const GltfDocument& doc, const GltfShape& shape, const std::vector<Positions*>& poses,
                  Positions& normals, std::vector<Triangle>& faces, Scene& scene);

}  // namespace shapespline
