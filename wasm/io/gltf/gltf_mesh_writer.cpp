#include "io/gltf/gltf_mesh_writer.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "io/gltf/gltf_vertices.h"
#include "io/gltf/tangents.h"

namespace shapespline {

namespace {

using nlohmann::json;

const char* alphaName(Material::Alpha alpha) {
  return alpha == Material::Alpha::Mask ? "MASK" : alpha == Material::Alpha::Blend ? "BLEND" : "OPAQUE";
}

int wrapMode(Material::Wrap wrap) {
  return wrap == Material::Wrap::Clamp ? 33071 : wrap == Material::Wrap::Mirror ? 33648 : 10497;
}

// Writes materials with their textures. Images go into the binary chunk.
struct LookWriter {
  GlbBuilder& glb;
  const Scene& scene;
  std::vector<int> imageOf;  // output index of each image in scene.images; -1 until written

  void use(const char* extension, const char* list) {
    json& names = glb.doc[list];
    if (std::find(names.begin(), names.end(), extension) == names.end()) names.push_back(extension);
  }

  int image(int index) {
    if (imageOf[index] >= 0) return imageOf[index];
    const Image& source = scene.images[index];
    const int view = glb.addView(glb.append(source.bytes.data(), source.bytes.size()));
    glb.doc["images"].push_back({{"bufferView", view}, {"mimeType", source.mimeType}});
    return imageOf[index] = static_cast<int>(glb.doc["images"].size()) - 1;
  }

  // Writes a texture for each use. Returns null without an image or coordinates.
  json texture(int imageIndex, const Material& m) {
    if (imageIndex < 0 || imageIndex >= static_cast<int>(scene.images.size()) || scene.uvs.empty()) return nullptr;
    const std::string& type = scene.images[imageIndex].mimeType;
    json out;
    const json source = {{"source", image(imageIndex)}};
    if (type == "image/webp" || type == "image/ktx2") {
      const char* extension = type == "image/webp" ? "EXT_texture_webp" : "KHR_texture_basisu";
      use(extension, "extensionsUsed");
      use(extension, "extensionsRequired");  // no fallback source exists
      out["extensions"][extension] = source;
    } else {
      out = source;
    }
    json sampler = {{"wrapS", wrapMode(m.wrapS)}, {"wrapT", wrapMode(m.wrapT)}};
    if (m.magFilter) sampler["magFilter"] = m.magFilter;
    if (m.minFilter) sampler["minFilter"] = m.minFilter;
    glb.doc["samplers"].push_back(std::move(sampler));
    out["sampler"] = glb.doc["samplers"].size() - 1;
    glb.doc["textures"].push_back(std::move(out));
    return {{"index", glb.doc["textures"].size() - 1}};
  }

  json material(const Material& m) {
    json pbr = {{"baseColorFactor", m.baseColor}, {"metallicFactor", m.metallic}, {"roughnessFactor", m.roughness}};
    json out = {{"doubleSided", m.doubleSided}, {"alphaMode", alphaName(m.alphaMode)}};
    out["name"] = m.name.empty() ? "material " + std::to_string(glb.doc["materials"].size() + 1) : m.name;
    if (m.alphaMode == Material::Alpha::Mask) out["alphaCutoff"] = m.alphaCutoff;
    if (m.emissive != std::array<float, 3>{0, 0, 0}) out["emissiveFactor"] = m.emissive;
    if (json t = texture(m.baseColorImage, m); !t.is_null()) pbr["baseColorTexture"] = t;
    if (json t = texture(m.metallicRoughnessImage, m); !t.is_null()) pbr["metallicRoughnessTexture"] = t;
    if (json t = texture(m.normalImage, m); !t.is_null()) {
      out["normalTexture"] = t;
      out["normalTexture"]["scale"] = m.normalScale;
    }
    if (json t = texture(m.occlusionImage, m); !t.is_null()) {
      out["occlusionTexture"] = t;
      out["occlusionTexture"]["strength"] = m.occlusionStrength;
    }
    if (json t = texture(m.emissiveImage, m); !t.is_null()) out["emissiveTexture"] = t;
    out["pbrMetallicRoughness"] = std::move(pbr);
    if (m.unlit) {
      use("KHR_materials_unlit", "extensionsUsed");
      out["extensions"]["KHR_materials_unlit"] = json::object();
    }
    return out;
  }

  void write() {
    imageOf.assign(scene.images.size(), -1);
    for (const Material& m : scene.materials) glb.doc["materials"].push_back(material(m));
  }
};

}  // namespace

void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values) {
  if (values.empty()) return;
  values.reserve(values.size() + width * seams.copyOf.size());
  for (int v : seams.copyOf)
    for (std::size_t i = 0; i < width; ++i) values.push_back(values[width * v + i]);
}

void writeLook(GlbBuilder& glb, const Scene& scene) { LookWriter{glb, scene, {}}.write(); }

namespace {

int addIndices(GlbBuilder& glb, const DrawnPrimitive& primitive) {
  const auto collect = [&](auto& out) {
    out.reserve(3 * primitive.faces.size());
    for (const Triangle& face : primitive.faces)
      for (int v : face) out.push_back(v);
  };
  if (primitive.vertices.size() <= 0xffff) {  // index 65535 would restart a strip
    std::vector<std::uint16_t> indices;
    collect(indices);
    return glb.addArray(indices, "SCALAR", 1, glUnsignedShort, glElementArrayBuffer);
  }
  std::vector<std::uint32_t> indices;
  collect(indices);
  return glb.addArray(indices, "SCALAR", 1, glUnsignedInt, glElementArrayBuffer);
}

}  // namespace

// Without stored tangents, viewers draw a normal map in different ways. Morph targets leave the tangents unchanged,
// because few viewers support moving ones.
void MeshWriter::makeTangents(std::span<const float> positions, std::span<const float> normals) {
  const auto& m = scene.materials;
  const bool wanted = std::any_of(m.begin(), m.end(), [](const Material& one) { return one.normalImage >= 0; });
  if (!wanted || normals.empty() || scene.uvs.size() != 2 * vertices) return;
  tangents = tangentsOf(positions, normals, scene.uvs, faces);
}

// Lets the file restore the mesh's vertices, even after another program reordered, split or welded them.
void MeshWriter::makeVertexNumbers() {
  const std::vector<int>& copyOf = scene.seams.copyOf;
  numbers.resize(vertices - copyOf.size());
  for (std::size_t v = 0; v < numbers.size(); ++v) numbers[v] = static_cast<float>(v);
  numbers.insert(numbers.end(), copyOf.begin(), copyOf.end());
  if (copyOf.empty()) return;
  drawnNumbers.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) drawnNumbers[v] = static_cast<float>(v);
}

json MeshWriter::primitive(const DrawnPrimitive& drawn, json attributes) {
  const auto add = [&](std::string_view name, const std::vector<float>& values, const char* type, int width) {
    if (values.size() != width * vertices) return;
    const auto own = gathered(std::span<const float>(values), width, drawn);
    attributes[std::string(name)] = glb.addArray(own, type, width, glFloat, glArrayBuffer);
  };
  std::vector<float> colors = scene.colors;
  addCopies(scene.seams, 4, colors);
  add("TEXCOORD_0", scene.uvs, "VEC2", 2);
  add("TANGENT", tangents, "VEC4", 4);
  add("COLOR_0", colors, "VEC4", 4);
  add(vertexAttribute, numbers, "SCALAR", 1);
  add(drawnAttribute, drawnNumbers, "SCALAR", 1);
  if (drawn.material < 0 && plain < 0) plain = addPlainMaterial();
  return {{"attributes", std::move(attributes)},
          {"indices", addIndices(glb, drawn)},
          {"material", drawn.material < 0 ? plain : drawn.material}};
}

// glTF's default material is polished metal, which looks black without an environment, and white is invisible on a
// white page. This material is the clay of web/viewer/shape.ts, so the file looks the same when opened again.
int MeshWriter::addPlainMaterial() {
  glb.doc["materials"].push_back({{"name", "plain"},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorFactor", {0.584, 0.462, 0.371, 1}},  // linear RGBA
                                    {"metallicFactor", 0},
                                    {"roughnessFactor", 0.6}}},
                                  {"doubleSided", true}});
  return static_cast<int>(glb.doc["materials"].size()) - 1;
}

}  // namespace shapespline
