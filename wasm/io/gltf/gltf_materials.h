// Reads materials, texture coordinates, vertex colours and images of a glTF scene.
#pragma once

#include "io/base/scene.h"
#include "io/gltf/gltf_shape.h"

namespace shapespline {

/// Collects the materials and textures of the shape's faces, in its vertex order. A broken texture is omitted with a
/// warning in `shape.warnings`.
Scene readLook(GltfDocument& doc, GltfShape& shape);

}  // namespace shapespline
