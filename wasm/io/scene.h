// What a file holds beside the poses: enough to draw the shape as it was meant and to write it back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shapespline {

/// A surface's look, as far as it is kept (glTF 2.0 metallic-roughness).
struct Material {
  std::string name;
  std::array<float, 4> baseColor{1, 1, 1, 1};  ///< linear RGBA
  float metallic = 0, roughness = 1;
  bool doubleSided = false;
  enum class Alpha { Opaque, Mask, Blend } alpha = Alpha::Opaque;
  float alphaCutoff = 0.5f;
  bool unlit = false;  ///< KHR_materials_unlit
  std::array<float, 3> emissive{0, 0, 0};  ///< linear RGB
  float normalScale = 1, occlusionStrength = 1;
  /// Indices into Scene::images, or -1. All of them are looked up with Scene::uvs.
  int baseColorImage = -1, metallicRoughnessImage = -1, normalImage = -1, occlusionImage = -1, emissiveImage = -1;
  enum class Wrap { Repeat, Clamp, Mirror } wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
};

/// An encoded image, byte for byte as it came; nothing here decodes it.
struct Image {
  std::string mimeType;  ///< "image/png", "image/jpeg", ..., told from the bytes where they tell
  std::vector<std::uint8_t> bytes;
};

/// A run of faces drawn with one material.
struct MaterialGroup {
  int start = 0, count = 0;  ///< faces
  int material = -1;
};

struct Scene {
  std::vector<float> uvs;     ///< 2n, or empty; origin at the upper left (glTF)
  std::vector<float> colors;  ///< 4n linear RGBA, or empty
  std::vector<MaterialGroup> groups;
  std::vector<Material> materials;
  std::vector<Image> images;
};

}  // namespace shapespline
