// The visible content of a written file: primitives with materials and textures.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/drawn_primitives.h"
#include "io/gltf/glb_builder.h"

namespace shapespline {

/// Values of the mesh's own vertices, `width` each -> those of the drawn ones.
void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values);

/// Adds the scene's materials and their textures; images go into the binary chunk.
void writeLook(GlbBuilder& glb, const Scene& scene);

/// The mesh but for its positions and normals.
class MeshWriter {
 public:
  /// `faces` are of `vertices` drawn ones. All must outlive the writer.
  MeshWriter(GlbBuilder& glb, const std::vector<Triangle>& faces, const Scene& scene, std::size_t vertices)
      : glb(glb), faces(faces), scene(scene), vertices(vertices) {}

  /// Only if a material needs them.
  void makeTangents(std::span<const float> positions, std::span<const float> normals);

  /// From here on, primitives state the mesh vertices of their vertices.
  void makeVertexNumbers();

  /// Adds look, faces and material to the given attributes.
  nlohmann::json primitive(const DrawnPrimitive& drawn, nlohmann::json attributes);

 private:
  GlbBuilder& glb;
  const std::vector<Triangle>& faces;
  const Scene& scene;
  std::size_t vertices;
  std::vector<float> tangents, numbers, drawnNumbers;  // per drawn vertex, or empty
  int plain = -1;                                      // the material of faces that have none

  int addPlainMaterial();
};

}  // namespace shapespline
