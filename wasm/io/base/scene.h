// What a file holds beside the poses: enough to draw the shape as it was meant and to write it back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A surface's look, as far as it is kept (glTF 2.0 metallic-roughness).
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
  std::string mimeType;  ///< "image/png", "image/jpeg", ..., told from the bytes where they tell
  std::vector<std::uint8_t> bytes;
};

/// An object's run of faces, and what it is called.
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

/// Where texture coordinates jump between faces that share a vertex, as OBJ has them: what is drawn has more vertices
/// than the mesh then, copies of some of its n. The motion, and every file but GLB, knows the mesh alone.
struct Seams {
  std::vector<int> copyOf;      ///< drawn vertices 0 to n-1 are the mesh's own, n + i is a copy of vertex copyOf[i]
  std::vector<Triangle> faces;  ///< m, of drawn vertices; empty without copies
};

struct Scene {
  std::vector<float> uvs;     ///< 2 a drawn vertex, or empty; origin at the upper left (glTF)
  std::vector<float> colors;  ///< 4n linear RGBA, or empty
  Seams seams;
  /// Of how many faces each polygon of the file was cut, in their order; empty where all were triangles.
  std::vector<int> polygons;
  std::vector<MaterialGroup> groups;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<ObjectFaces> objects;  ///< in the order of the faces, all of them; empty where the file knows none
};

}  // namespace shapespline
