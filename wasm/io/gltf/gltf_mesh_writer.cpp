#include "io/gltf/gltf_mesh_writer.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "io/gltf/gltf_seams.h"
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

// Materials with their textures; images go into the binary chunk.
struct LookWriter {
  GlbBuilder& glb;
  const Scene& scene;
  std::vector<int> imageOf;  // of scene.images; -1 not written yet

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

  // A texture of its own for every use; null where there is no image or nothing to look it up with.
  json texture(int imageIndex, const Material& m) {
    if (imageIndex < 0 || imageIndex >= static_cast<int>(scene.images.size()) || scene.uvs.empty()) return nullptr;
    const std::string& type = scene.images[imageIndex].mimeType;
    json out;
    const json source = {{"source", image(imageIndex)}};
    if (type == "image/webp" || type == "image/ktx2") {
      const char* extension = type == "image/webp" ? "EXT_texture_webp" : "KHR_texture_basisu";
      use(extension, "extensionsUsed");
      use(extension, "extensionsRequired");  // there is no other source
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
    if (!m.name.empty()) out["name"] = m.name;
    if (m.alphaMode == Material::Alpha::Mask) out["alphaCutoff"] = m.alphaCutoff;
    if (m.emissive != std::array<float, 3>{0, 0, 0}) out["emissiveFactor"] = m.emissive;
    if (json t = texture(m.baseColorImage, m); !t.is_null()) pbr["baseColorTexture"] = t;
    if (json t = texture(m.metallicRoughnessImage, m); !t.is_null()) pbr["metallicRoughnessTexture"] = t;
    if (json t = texture(m.normalImage, m); !t.is_null())
      out["normalTexture"] = t, out["normalTexture"]["scale"] = m.normalScale;
    if (json t = texture(m.occlusionImage, m); !t.is_null())
      out["occlusionTexture"] = t, out["occlusionTexture"]["strength"] = m.occlusionStrength;
    if (json t = texture(m.emissiveImage, m); !t.is_null()) out["emissiveTexture"] = t;
    out["pbrMetallicRoughness"] = std::move(pbr);
    if (m.unlit)
      use("KHR_materials_unlit", "extensionsUsed"), out["extensions"]["KHR_materials_unlit"] = json::object();
    return out;
  }

  void write() {
    imageOf.assign(scene.images.size(), -1);
    for (const Material& m : scene.materials) glb.doc["materials"].push_back(material(m));
  }
};

// The scene's groups, with those faces that no group names in groups without material, in the order of the faces.
std::vector<MaterialGroup> completeGroups(const Scene& scene, int faces) {
  std::vector<MaterialGroup> out;
  int next = 0;
  const auto add = [&](int end, int material) {
    end = std::min(end, faces);
    if (end > next) out.push_back({next, end - next, material}), next = end;
  };
  for (const MaterialGroup& g : scene.groups) {
    add(g.start, -1);
    add(g.start + g.count, g.material);
  }
  add(faces, -1);
  return out;
}

}  // namespace

void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values) {
  if (values.empty()) return;
  values.reserve(values.size() + width * seams.copyOf.size());
  for (int v : seams.copyOf)
    for (std::size_t i = 0; i < width; ++i) values.push_back(values[width * v + i]);
}

void writeLook(GlbBuilder& glb, const Scene& scene) { LookWriter{glb, scene, {}}.write(); }

int MeshWriter::addIndices(const MaterialGroup& group) {
  const auto collect = [&](auto& out) {
    out.reserve(3 * static_cast<std::size_t>(group.count));
    for (int f = group.start; f < group.start + group.count; ++f)
      for (int v : faces[f]) out.push_back(v);
  };
  if (vertices <= 0xffff) {  // 65535 itself would restart a strip
    std::vector<std::uint16_t> indices;
    collect(indices);
    return glb.addArray(indices, "SCALAR", 1, kUnsignedShort, kElementArrayBuffer);
  }
  std::vector<std::uint32_t> indices;
  collect(indices);
  return glb.addArray(indices, "SCALAR", 1, kUnsignedInt, kElementArrayBuffer);
}

// A normal map without tangents would look different in every viewer. They do not turn with the morph targets, for
// which few viewers have a place.
void MeshWriter::addTangents(json& attributes, std::span<const float> positions, std::span<const float> normals) {
  const auto& m = scene.materials;
  const bool wanted = std::any_of(m.begin(), m.end(), [](const Material& one) { return one.normalImage >= 0; });
  if (!wanted || normals.empty() || scene.uvs.size() != 2 * vertices) return;
  attributes["TANGENT"] =
      glb.addArray(tangentsOf(positions, normals, scene.uvs, faces), "VEC4", 4, kFloat, kArrayBuffer);
}

void MeshWriter::addColors(json& attributes) {
  std::vector<float> colors = scene.colors;
  addCopies(scene.seams, 4, colors);
  if (colors.size() == 4 * vertices) attributes["COLOR_0"] = glb.addArray(colors, "VEC4", 4, kFloat, kArrayBuffer);
}

// So that the file opens again with the mesh's own vertices.
void MeshWriter::addVertexNumbers(json& attributes) {
  const std::vector<int>& copyOf = scene.seams.copyOf;
  if (copyOf.empty()) return;
  std::vector<float> numbers(vertices - copyOf.size());
  for (std::size_t v = 0; v < numbers.size(); ++v) numbers[v] = static_cast<float>(v);
  numbers.insert(numbers.end(), copyOf.begin(), copyOf.end());
  attributes[std::string(kVertexAttribute)] = glb.addArray(numbers, "SCALAR", 1, kFloat, kArrayBuffer);
}

json MeshWriter::primitives(json attributes, const json& targets) {
  if (scene.uvs.size() == 2 * vertices)
    attributes["TEXCOORD_0"] = glb.addArray(scene.uvs, "VEC2", 2, kFloat, kArrayBuffer);
  addColors(attributes);
  addVertexNumbers(attributes);
  json out = json::array();
  int plain = -1;
  for (const MaterialGroup& group : completeGroups(scene, static_cast<int>(faces.size()))) {
    json primitive = {{"attributes", attributes}, {"indices", addIndices(group)}};
    if (group.material >= 0 && group.material < static_cast<int>(scene.materials.size()))
      primitive["material"] = group.material;
    else primitive["material"] = plain = plain < 0 ? addPlainMaterial() : plain;
    if (!targets.empty()) primitive["targets"] = targets;
    out.push_back(std::move(primitive));
  }
  return out;
}

// glTF's own default is polished metal, which is black where there is nothing to mirror.
int MeshWriter::addPlainMaterial() {
  glb.doc["materials"].push_back(
      {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}, {"doubleSided", true}});
  return static_cast<int>(glb.doc["materials"].size()) - 1;
}

}  // namespace shapespline
