// Appearance of a shape, kept from the file for drawing and for export.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// The supported part of a material (glTF 2.0 metallic-roughness).
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
  /// Indices into Scene::images, or -1. All textures use Scene::uvs.
  int baseColorImage = -1, metallicRoughnessImage = -1, normalImage = -1, occlusionImage = -1, emissiveImage = -1;
  enum class Wrap { Repeat, Clamp, Mirror } wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
  int magFilter = 0, minFilter = 0;  ///< glTF codes; 0 = the renderer decides
};

/// An encoded image, byte for byte as stored in the file. Images are never decoded here.
struct Image {
  std::string mimeType;  ///< "image/png", "image/jpeg", ...; from the bytes if recognised
  std::vector<std::uint8_t> bytes;
};

/// Name and range of faces of an object.
struct ObjectFaces {
  std::string name;  ///< display name; generated if the file has none
  int start = 0, count = 0;
  std::string nodeName{}, meshName{}, path{};  ///< names in the file, or empty; `path`: names of the ancestor nodes
  bool isGroup = false;                        ///< an OBJ group (g), not an object (o)
};

/// A range of faces with one material.
struct MaterialGroup {
  int start = 0, count = 0;  ///< in faces
  int material = -1;
  std::string name{};  ///< name of a material that an OBJ uses but does not define
};

/// Texture coordinates may differ between faces at a shared vertex, as in OBJ. Such a vertex is drawn several times:
/// copies have indices from n on. The motion, and every file but GLB, uses mesh vertices only.
struct Seams {
  std::vector<int> copyOf;      ///< drawn vertices 0 to n-1 are mesh vertices; n + i copies vertex copyOf[i]
  std::vector<Triangle> faces;  ///< m faces of drawn vertices; empty without copies
};

struct Scene {
  std::vector<float> uvs;     ///< 2 per drawn vertex, or empty; origin at the upper left (glTF)
  std::vector<float> colors;  ///< 4n linear RGBA, or empty
  Seams seams;
  /// Number of triangles of each polygon in the file, in file order; empty if all polygons are triangles.
  std::vector<int> polygons;
  std::vector<MaterialGroup> groups;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<ObjectFaces> objects;  ///< objects cover all faces, in face order; empty if the file has none
};

}  // namespace shapespline
