// What a written file shows: the mesh's primitives with their materials and textures.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/glb_builder.h"

namespace shapespline {

/// Values of the mesh's own vertices, `width` each -> those of the drawn ones.
void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values);

/// Adds the scene's materials and their textures; images go into the binary chunk.
void writeLook(GlbBuilder& glb, const Scene& scene);

/// The mesh but for its positions and normals.
struct MeshWriter {
  GlbBuilder& glb;
  const std::vector<Triangle>& faces;  ///< of drawn vertices
  const Scene& scene;
  std::size_t vertices = 0;  ///< that are drawn

  /// Where a material asks for them.
  void addTangents(nlohmann::json& attributes, std::span<const float> positions, std::span<const float> normals);

  /// A primitive for every material group, all on the same vertices.
  nlohmann::json primitives(nlohmann::json attributes, const nlohmann::json& targets);

 private:
  int addIndices(const MaterialGroup& group);
  void addColors(nlohmann::json& attributes);
  void addVertexNumbers(nlohmann::json& attributes);
  int addPlainMaterial();
};

}  // namespace shapespline
