// The look of a shape, kept from the file: enough to draw it as intended and to write it back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// The supported part of a surface's look (glTF 2.0 metallic-roughness).
struct Material {
  std::string name;
  std::array<float, 4> baseColor{1, 1, 1, 1};  ///< linear RGBA
  float metallic = 0, roughness = 1;
  bool doubleSided = false;
  enum class Alpha { Opaque, Mask, Blend } alphaMode = Alpha::Opaque;
  float alphaCutoff = 0.5f;
  bool unlit = false;                      ///< KHR_materials_unlit
  std::array<float, 3> emissive{0, 0, 0};  ///< linear RGB
  float normalScale = 1, occlusionStrength = 1;
  /// Indices into Scene::images, or -1. All of them are looked up with Scene::uvs.
  int baseColorImage = -1, metallicRoughnessImage = -1, normalImage = -1, occlusionImage = -1, emissiveImage = -1;
  enum class Wrap { Repeat, Clamp, Mirror } wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
  int magFilter = 0, minFilter = 0;  ///< as glTF numbers them; 0 = left to who draws
};

/// An encoded image, byte for byte as it came; nothing here decodes it.
struct Image {
  std::string mimeType;  ///< "image/png", "image/jpeg", ..., from the bytes if recognised
  std::vector<std::uint8_t> bytes;
};

/// Name and range of faces of an object.
struct ObjectFaces {
  std::string name;  ///< as messages and lists call it; made up where the file has none
  int start = 0, count = 0;
  std::string nodeName{}, meshName{}, path{};  ///< as the file has them, or empty; `path`: of the nodes above it
  bool isGroup = false;                        ///< OBJ: g, not o
};

/// A run of faces drawn with one material.
struct MaterialGroup {
  int start = 0, count = 0;  ///< faces
  int material = -1;
  std::string name{};  ///< of a material that an OBJ names without saying how it looks
};

/// Texture coordinates may jump between faces that share a vertex, as in OBJ. Then there are more drawn vertices than
/// mesh vertices: copies follow the n. The motion, and every file but GLB, uses mesh vertices only.
struct Seams {
  std::vector<int> copyOf;      ///< drawn vertices 0 to n-1 are the mesh's own, n + i is a copy of vertex copyOf[i]
  std::vector<Triangle> faces;  ///< m, of drawn vertices; empty without copies
};

struct Scene {
  std::vector<float> uvs;     ///< 2 a drawn vertex, or empty; origin at the upper left (glTF)
  std::vector<float> colors;  ///< 4n linear RGBA, or empty
  Seams seams;
  /// Number of triangles of each polygon of the file, in their order; empty if all polygons were triangles.
  std::vector<int> polygons;
  std::vector<MaterialGroup> groups;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<ObjectFaces> objects;  ///< in the order of the faces, all of them; empty where the file knows none
};

}  // namespace shapespline
