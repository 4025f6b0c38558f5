#include "io/gltf/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/gltf/gltf_accessor.h"

namespace shapespline {

namespace {

// Reads materials, and keeps and renumbers the images in use.
struct LookReader {
  GltfDocument& doc;
  GltfShape& shape;
  Scene scene;
  std::vector<int> newImage;  // new index of each image in doc.images; -1 until used
  int brokenTextures = 0, otherCoordinates = 0;

  int brokenTexture() {
    ++brokenTextures;
    return -1;
  }

  // Index into doc.images of a texture's source, or of an extension's source that most browsers decode.
  int sourceImage(int texture) {
    if (texture < 0) return -1;
    if (texture >= static_cast<int>(doc.model.textures.size())) return brokenTexture();
    const tinygltf::Texture& t = doc.model.textures[texture];
    for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu"})
      if (const auto it = t.extensions.find(extension); it != t.extensions.end() && it->second.Has("source"))
        if (const int image = it->second.Get("source").GetNumberAsInt(); hasBytes(image)) return doc.imageOf[image];
    if (!hasBytes(t.source)) return brokenTexture();
    return doc.imageOf[t.source];
  }

  bool hasBytes(int image) const {
    return image >= 0 && image < static_cast<int>(doc.imageOf.size()) && doc.imageOf[image] >= 0;
  }

  int keepImage(int texture) {
    const int image = sourceImage(texture);
    if (image < 0) return -1;
    if (newImage[image] < 0) {
      newImage[image] = static_cast<int>(scene.images.size());
      scene.images.push_back(std::move(doc.images[image]));
    }
    return newImage[image];
  }

  // Only the base colour's set of texture coordinates is kept.
  int keepImage(int texture, int coordinates, int kept) {
    if (texture < 0 || coordinates == kept) return keepImage(texture);
    ++otherCoordinates;
    return -1;
  }

  static Material::Wrap wrapOf(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Material::Wrap::Clamp;
    return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Material::Wrap::Mirror : Material::Wrap::Repeat;
  }

  static int filterOf(int mode) {
    const bool known = mode == TINYGLTF_TEXTURE_FILTER_NEAREST || mode == TINYGLTF_TEXTURE_FILTER_LINEAR ||
                       (mode >= TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST &&
                        mode <= TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR);
    return known ? mode : 0;
  }

  void readSampler(int texture, Material& out) const {
    if (texture < 0 || texture >= static_cast<int>(doc.model.textures.size())) return;
    const int sampler = doc.model.textures[texture].sampler;
    if (sampler < 0 || sampler >= static_cast<int>(doc.model.samplers.size())) return;
    const tinygltf::Sampler& s = doc.model.samplers[sampler];
    out.wrapS = wrapOf(s.wrapS);
    out.wrapT = wrapOf(s.wrapT);
    if (const int filter = filterOf(s.magFilter); filter <= TINYGLTF_TEXTURE_FILTER_LINEAR) out.magFilter = filter;
    out.minFilter = filterOf(s.minFilter);
  }

  static float unit(double value) {
    return static_cast<float>(value >= 0 ? std::min(value, 1.0) : 0);
  }  // also turns NaN into 0
  static float finite(double value) { return std::abs(value) < 1e6 ? static_cast<float>(value) : 0; }

  Material readMaterial(const tinygltf::Material& source) {
    const auto& pbr = source.pbrMetallicRoughness;
    Material out;
    out.name = source.name;
    for (int c = 0; c < 4 && c < static_cast<int>(pbr.baseColorFactor.size()); ++c)
      out.baseColor[c] = unit(pbr.baseColorFactor[c]);
    for (int c = 0; c < 3 && c < static_cast<int>(source.emissiveFactor.size()); ++c)
      out.emissive[c] = unit(source.emissiveFactor[c]);
    out.metallic = unit(pbr.metallicFactor);
    out.roughness = unit(pbr.roughnessFactor);
    out.doubleSided = source.doubleSided;
    out.alphaCutoff = unit(source.alphaCutoff);
    if (source.alphaMode == "MASK") out.alphaMode = Material::Alpha::Mask;
    if (source.alphaMode == "BLEND") out.alphaMode = Material::Alpha::Blend;
    out.unlit = source.extensions.count("KHR_materials_unlit") > 0;
    const int kept = coordinatesOf(source);
    readSampler(pbr.baseColorTexture.index, out);
    out.baseColorImage = keepImage(pbr.baseColorTexture.index);
    out.metallicRoughnessImage =
        keepImage(pbr.metallicRoughnessTexture.index, pbr.metallicRoughnessTexture.texCoord, kept);
    out.normalImage = keepImage(source.normalTexture.index, source.normalTexture.texCoord, kept);
    out.occlusionImage = keepImage(source.occlusionTexture.index, source.occlusionTexture.texCoord, kept);
    out.emissiveImage = keepImage(source.emissiveTexture.index, source.emissiveTexture.texCoord, kept);
    out.normalScale = finite(source.normalTexture.scale);
    out.occlusionStrength = unit(source.occlusionTexture.strength);
    return out;
  }

  // Visits textures by priority. The first one present decides which coordinates are kept.
  template <class Visit>
  static void visitTextures(const tinygltf::Material& m, Visit visit) {
    visit(m.pbrMetallicRoughness.baseColorTexture);
    visit(m.normalTexture);
    visit(m.pbrMetallicRoughness.metallicRoughnessTexture);
    visit(m.emissiveTexture);
    visit(m.occlusionTexture);
  }

  static int coordinatesOf(const tinygltf::Material& m) {
    int kept = -1;
    visitTextures(m, [&](const auto& texture) {
      if (kept < 0 && texture.index >= 0) kept = std::max(texture.texCoord, 0);
    });
    return std::max(kept, 0);
  }

  // KHR_texture_transform of the deciding texture, as a 2 x 3 matrix.
  static Eigen::Matrix<double, 2, 3> transformOf(const tinygltf::Material& m) {
    Eigen::Matrix<double, 2, 3> out = Eigen::Matrix<double, 2, 3>::Identity();
    bool decided = false;
    visitTextures(m, [&](const auto& texture) {
      if (decided || texture.index < 0) return;
      decided = true;
      const auto it = texture.extensions.find("KHR_texture_transform");
      if (it == texture.extensions.end()) return;
      const auto number = [](const tinygltf::Value& v, double otherwise) {
        return v.IsNumber() ? v.GetNumberAsDouble() : otherwise;
      };
      const auto pair = [&](const char* name, int i, double otherwise) {
        const tinygltf::Value& v = it->second.Get(name);
        return v.IsArray() && v.ArrayLen() == 2 ? number(v.Get(i), otherwise) : otherwise;
      };
      const double angle = number(it->second.Get("rotation"), 0), c = std::cos(angle), s = std::sin(angle);
      const double sx = pair("scale", 0, 1), sy = pair("scale", 1, 1);
      out << c * sx, s * sy, pair("offset", 0, 0), -s * sx, c * sy, pair("offset", 1, 0);
    });
    return out;
  }

  const tinygltf::Material* materialOf(const GltfPart& part) const {
    const int index = part.primitive->material;
    return index >= 0 && index < static_cast<int>(doc.model.materials.size()) ? &doc.model.materials[index] : nullptr;
  }

  // Reads `components` numbers per vertex of an attribute. Returns nothing if it is missing or broken.
  std::vector<double> vertexNumbers(const GltfPart& part, const std::string& name, int components) {
    const auto it = part.primitive->attributes.find(name);
    if (it == part.primitive->attributes.end() || accessorCount(doc, it->second) != part.positions.size()) return {};
    auto numbers = readNumbers(doc, it->second, components, name + " of " + part.name);
    return numbers ? std::move(*numbers) : std::vector<double>();
  }

  void readCoordinates(const GltfPart& part) {
    const tinygltf::Material* material = materialOf(part);
    const int set = material ? coordinatesOf(*material) : 0;
    const auto numbers = vertexNumbers(part, "TEXCOORD_" + std::to_string(set), 2);
    if (numbers.empty()) return;
    scene.uvs.resize(2 * static_cast<std::size_t>(shape.vertexCount), 0);
    const auto transform =
        material ? transformOf(*material) : Eigen::Matrix<double, 2, 3>(Eigen::Matrix<double, 2, 3>::Identity());
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
      const Vec2 uv = transform * Vec3(numbers[2 * v], numbers[2 * v + 1], 1);
      for (int c = 0; c < 2; ++c) scene.uvs[2 * (part.firstVertex + v) + c] = finite(uv[c]);
    }
  }

  // Some tools write black vertex colours by default, which would blacken the whole shape.
  static bool isAllZero(const std::vector<double>& colors, int components) {
    for (std::size_t i = 0; i < colors.size(); ++i)
      if (static_cast<int>(i % components) < 3 && colors[i] != 0) return false;
    return true;
  }

  void readColors(const GltfPart& part) {
    const auto it = part.primitive->attributes.find("COLOR_0");
    if (it == part.primitive->attributes.end() || it->second < 0 ||
        it->second >= static_cast<int>(doc.model.accessors.size()))
      return;
    const int components = doc.model.accessors[it->second].type == TINYGLTF_TYPE_VEC3 ? 3 : 4;
    const auto numbers = vertexNumbers(part, "COLOR_0", components);
    if (numbers.empty() || isAllZero(numbers, components)) return;
    scene.colors.resize(4 * static_cast<std::size_t>(shape.vertexCount), 1);
    for (std::size_t v = 0; v < part.positions.size(); ++v)
      for (int c = 0; c < components; ++c)
        scene.colors[4 * (part.firstVertex + v) + c] = unit(numbers[components * v + c]);
  }

  void warn(const char* code, int count, const char* message) {
    if (count > 0) shape.warnings.push_back({code, doc.where + ": " + message, count});
  }

  Scene read() {
    newImage.assign(doc.images.size(), -1);
    scene.groups = shape.groups;
    for (const tinygltf::Material& material : doc.model.materials) scene.materials.push_back(readMaterial(material));
    for (MaterialGroup& group : scene.groups)
      if (group.material >= static_cast<int>(scene.materials.size())) group.material = -1;
    for (const GltfPart& part : shape.parts) {
      readCoordinates(part);
      readColors(part);
    }
    warn("missing-texture", brokenTextures, "textures without an image are ignored.");
    warn("other-coordinates", otherCoordinates,
         "textures with texture coordinates other than the base colour's are ignored.");
    return std::move(scene);
  }
};

}  // namespace

Scene readLook(GltfDocument& doc, GltfShape& shape) { return LookReader{doc, shape, {}, {}}.read(); }

}  // namespace shapespline
