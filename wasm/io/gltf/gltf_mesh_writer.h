// Writes primitives with materials and textures.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"
#include "io/gltf/drawn_primitives.h"
#include "io/gltf/glb_builder.h"

namespace shapespline {

/// Extends values of the mesh vertices, `width` numbers each, to the drawn vertices.
void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values);

/// Writes the scene's materials and their textures. Images go into the binary chunk.
void writeLook(GlbBuilder& glb, const Scene& scene);

/// Writes everything of the mesh except positions and normals.
class MeshWriter {
 public:
  /// `faces`: indices of drawn vertices. `vertices`: number of drawn vertices. All arguments must outlive the writer.
  MeshWriter(GlbBuilder& glb, const std::vector<Triangle>& faces, const Scene& scene, std::size_t vertices)
      : glb(glb), faces(faces), scene(scene), vertices(vertices) {}

  /// Computes tangents if a material needs them.
  void makeTangents(std::span<const float> positions, std::span<const float> normals);

  /// Makes all further primitives store the mesh vertex of each of their vertices.
  void makeVertexNumbers();

  /// Completes the given attributes with colours, coordinates, faces and material.
  nlohmann::json primitive(const DrawnPrimitive& drawn, nlohmann::json attributes);

 private:
  GlbBuilder& glb;
  const std::vector<Triangle>& faces;
  const Scene& scene;
  std::size_t vertices;
  std::vector<float> tangents, numbers, drawnNumbers;  // values per drawn vertex, or empty
  int plain = -1;                                      // material index for faces without material, or -1

  int addPlainMaterial();
};

}  // namespace shapespline
