// Poses and motions as GLB. The JSON is put together here: tinygltf's serializer would want every byte twice.
#include <algorithm>
#include <cmath>
#include <cstring>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "io/export.h"
#include "io/byte_text.h"
#include "io/gltf_accessor.h"  // kMostElements
#include "io/gltf_seams.h"
#include "io/tangents.h"

namespace shapespline {

namespace {

using nlohmann::json;

constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
// Up to here the one-hot weight matrix (frames x targets floats, 4 MB at most) is written out, because every reader
// understands that; beyond, as a sparse accessor, which grows with the frames instead of their square.
constexpr std::size_t kMostDenseFrames = 1024;

// Whole numbers in a file are read up to here (gltf_json); other programs fail there as well.
constexpr std::uint64_t kMostGlbBytes = 0x7fffffff;

// The binary chunk and the JSON that describes it, growing together.
struct GlbBuilder {
  json doc = {{"asset", {{"version", "2.0"}, {"generator", "shapespline"}}}};
  std::vector<std::uint8_t> bin;

  void align() { bin.resize((bin.size() + 3) / 4 * 4, 0); }

  int addView(std::size_t start, int target = 0, int stride = 0) {
    json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", bin.size() - start}};
    if (target) view["target"] = target;
    if (stride) view["byteStride"] = stride;
    align();
    doc["bufferViews"].push_back(std::move(view));
    return static_cast<int>(doc["bufferViews"].size()) - 1;
  }

  template <class T>
  std::size_t append(const T* values, std::size_t count) {
    align();
    const std::size_t start = bin.size();
    bin.resize(start + count * sizeof(T));
    if (count) std::memcpy(bin.data() + start, values, count * sizeof(T));
    return start;
  }

  int addAccessor(json accessor) {
    doc["accessors"].push_back(std::move(accessor));
    return static_cast<int>(doc["accessors"].size()) - 1;
  }

  template <class T>
  int addArray(const std::vector<T>& values, const char* type, int components, int componentType, int target = 0) {
    const int view = addView(append(values.data(), values.size()), target);
    return addAccessor({{"bufferView", view}, {"componentType", componentType}, {"count", values.size() / components}, {"type", type}});
  }

  // JSON chunk, then BIN chunk. The header is put before the bytes in place, so that they are held once.
  Result<std::vector<std::uint8_t>> finish() {
    align();
    doc["buffers"] = {{{"byteLength", bin.size()}}};
    std::string text = doc.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t total = 12 + 8 + text.size() + 8 + bin.size();
    if (total > kMostGlbBytes)
      return Error{ErrorCode::TooLarge, "The file would be " + sizeText(total) + "; a GLB of more than " + sizeText(kMostGlbBytes) +
                                            " would not open again. Export fewer frames."};
    std::string head = "glTF";
    const auto word = [&](std::uint64_t value) {
      for (int shift = 0; shift < 32; shift += 8) head += static_cast<char>(value >> shift & 0xff);
    };
    word(2), word(total), word(text.size());
    head += "JSON" + text;
    word(bin.size());
    head += std::string("BIN\0", 4);
    bin.insert(bin.begin(), head.begin(), head.end());
    return std::move(bin);
  }
};

const char* alphaName(Material::Alpha alpha) {
  return alpha == Material::Alpha::Mask ? "MASK" : alpha == Material::Alpha::Blend ? "BLEND" : "OPAQUE";
}

int wrapMode(Material::Wrap wrap) { return wrap == Material::Wrap::Clamp ? 33071 : wrap == Material::Wrap::Mirror ? 33648 : 10497; }

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
    json out = {{"doubleSided", m.doubleSided}, {"alphaMode", alphaName(m.alpha)}};
    if (!m.name.empty()) out["name"] = m.name;
    if (m.alpha == Material::Alpha::Mask) out["alphaCutoff"] = m.alphaCutoff;
    if (m.emissive != std::array<float, 3>{0, 0, 0}) out["emissiveFactor"] = m.emissive;
    if (json t = texture(m.baseColorImage, m); !t.is_null()) pbr["baseColorTexture"] = t;
    if (json t = texture(m.metallicRoughnessImage, m); !t.is_null()) pbr["metallicRoughnessTexture"] = t;
    if (json t = texture(m.normalImage, m); !t.is_null()) out["normalTexture"] = t, out["normalTexture"]["scale"] = m.normalScale;
    if (json t = texture(m.occlusionImage, m); !t.is_null()) out["occlusionTexture"] = t, out["occlusionTexture"]["strength"] = m.occlusionStrength;
    if (json t = texture(m.emissiveImage, m); !t.is_null()) out["emissiveTexture"] = t;
    out["pbrMetallicRoughness"] = std::move(pbr);
    if (m.unlit) use("KHR_materials_unlit", "extensionsUsed"), out["extensions"]["KHR_materials_unlit"] = json::object();
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

// Values of the mesh's own vertices, `width` each -> those of the drawn ones.
void addCopies(const Seams& seams, std::size_t width, std::vector<float>& values) {
  if (values.empty()) return;
  values.reserve(values.size() + width * seams.copyOf.size());
  for (int v : seams.copyOf)
    for (std::size_t i = 0; i < width; ++i) values.push_back(values[width * v + i]);
}

struct MeshWriter {
  GlbBuilder& glb;
  const std::vector<Triangle>& faces;  // of drawn vertices
  const Scene& scene;
  std::size_t vertices = 0;  // that are drawn

  int addIndices(const MaterialGroup& group) {
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
  void addTangents(json& attributes, std::span<const float> positions, std::span<const float> normals) {
    const auto& m = scene.materials;
    const bool wanted = std::any_of(m.begin(), m.end(), [](const Material& one) { return one.normalImage >= 0; });
    if (!wanted || normals.empty() || scene.uvs.size() != 2 * vertices) return;
    attributes["TANGENT"] = glb.addArray(tangentsOf(positions, normals, scene.uvs, faces), "VEC4", 4, kFloat, kArrayBuffer);
  }

  void addColors(json& attributes) {
    std::vector<float> colors = scene.colors;
    addCopies(scene.seams, 4, colors);
    if (colors.size() == 4 * vertices) attributes["COLOR_0"] = glb.addArray(colors, "VEC4", 4, kFloat, kArrayBuffer);
  }

  // So that the file opens again with the mesh's own vertices.
  void addVertexNumbers(json& attributes) {
    const std::vector<int>& copyOf = scene.seams.copyOf;
    if (copyOf.empty()) return;
    std::vector<float> numbers(vertices - copyOf.size());
    for (std::size_t v = 0; v < numbers.size(); ++v) numbers[v] = static_cast<float>(v);
    numbers.insert(numbers.end(), copyOf.begin(), copyOf.end());
    attributes[std::string(kVertexAttribute)] = glb.addArray(numbers, "SCALAR", 1, kFloat, kArrayBuffer);
  }

  // A primitive for every material group, all on the same vertices.
  json primitives(json attributes, const json& targets) {
    if (scene.uvs.size() == 2 * vertices) attributes["TEXCOORD_0"] = glb.addArray(scene.uvs, "VEC2", 2, kFloat, kArrayBuffer);
    addColors(attributes);
    addVertexNumbers(attributes);
    json out = json::array();
    int plain = -1;
    for (const MaterialGroup& group : completeGroups(scene, static_cast<int>(faces.size()))) {
      json primitive = {{"attributes", attributes}, {"indices", addIndices(group)}};
      if (group.material >= 0 && group.material < static_cast<int>(scene.materials.size())) primitive["material"] = group.material;
      else primitive["material"] = plain = plain < 0 ? addPlainMaterial() : plain;
      if (!targets.empty()) primitive["targets"] = targets;
      out.push_back(std::move(primitive));
    }
    return out;
  }

  // glTF's own default is polished metal, which is black where there is nothing to mirror.
  int addPlainMaterial() {
    glb.doc["materials"].push_back({{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}, {"doubleSided", true}});
    return static_cast<int>(glb.doc["materials"].size()) - 1;
  }
};

// One attribute of all frames: the base first, then every target's differences.
struct FrameAttribute {
  bool bounded;  // POSITION must state its bounds
  std::vector<float> base;
  std::vector<json> accessors;

  // Writes the vectors at the end of the chunk and describes them; the buffer view's number comes later.
  void add(GlbBuilder& glb, const std::vector<float>& values) {
    const std::size_t start = glb.append(values.data(), values.size());
    json accessor = {{"byteOffset", start}, {"componentType", kFloat}, {"count", values.size() / 3}, {"type", "VEC3"}};
    if (bounded) addBounds(accessor, values);
    accessors.push_back(std::move(accessor));
  }

  static void addBounds(json& accessor, const std::vector<float>& values) {
    float low[3] = {values[0], values[1], values[2]}, high[3] = {values[0], values[1], values[2]};
    for (std::size_t i = 0; i < values.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], values[i]);
      high[i % 3] = std::max(high[i % 3], values[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
};

// Unit normals only: where a shape has none (a vertex of degenerate faces), any will do.
void makeUnit(std::vector<float>& normals) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const double x = normals[i], y = normals[i + 1], z = normals[i + 2], length = std::sqrt(x * x + y * y + z * z);
    const bool usable = length > 1e-6 && std::isfinite(length);
    normals[i] = usable ? static_cast<float>(x / length) : 0;
    normals[i + 1] = usable ? static_cast<float>(y / length) : 0;
    normals[i + 2] = usable ? static_cast<float>(z / length) : 1;
  }
}

Status checkFinite(std::span<const float> values, int frame) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      return Error{ErrorCode::NotFinite, "Frame " + std::to_string(frame) + " has a vertex that is not finite (" +
                                             grouped(std::int64_t(i / 3)) + "). Choose a range closer to the keys.",
                   frame, static_cast<int>(i / 3)};
  return {};
}

struct AnimationWriter {
  const AnimationSource& source;
  GlbBuilder glb;
  std::size_t vertices = 0;  // of the mesh itself
  FrameAttribute positions{true, {}, {}}, normals{false, {}, {}};

  int frameCount() const { return static_cast<int>(source.seconds.size()) + source.stills; }

  Status checkTimes() const {
    const auto& t = source.seconds;
    bool increasing = !t.empty() && t[0] == 0;
    for (std::size_t k = 1; k < t.size(); ++k) increasing = increasing && static_cast<float>(t[k]) > static_cast<float>(t[k - 1]);
    if (increasing) return {};
    return Error{ErrorCode::InvalidOption, "The exported times must start at 0 and increase. Use a longer duration or fewer frames."};
  }

  Status checkWeights() const {
    const std::uint64_t weights = source.seconds.size() * static_cast<std::uint64_t>(frameCount() - 1);
    if (weights <= kMostElements) return {};
    return Error{ErrorCode::TooLarge, "An animation with " + grouped(std::int64_t(frameCount() - 1)) + " morph targets needs " +
                                          grouped(std::int64_t(weights)) + " weights, one for each at every frame; with more than " +
                                          grouped(std::int64_t(kMostElements)) + " the file would not open again. Export fewer frames."};
  }

  Status readFrame(int k, std::vector<float>& p, std::vector<float>& n) {
    if (Status frame = source.frame(k, p, n); !frame) return frame;
    if (k == 0) vertices = p.size() / 3;
    if (p.empty() || p.size() != 3 * vertices || (!n.empty() && n.size() != p.size()))
      return Error{ErrorCode::Internal, "Frame " + std::to_string(k) + " has another number of vertices."};
    if (Status finite = checkFinite(p, k); !finite) return finite;
    makeUnit(n);
    addCopies(source.scene->seams, 3, p);
    addCopies(source.scene->seams, 3, n);
    return {};
  }

  // Positions and normals of a frame lie beside each other, so that frames are asked for once and never held.
  Status writeFrames() {
    std::vector<float> p, n;
    for (int k = 0; k < frameCount(); ++k) {
      if (Status frame = readFrame(k, p, n); !frame) return frame;
      if (k == 0) {
        positions.base = p, normals.base = n;
        glb.bin.reserve(animatedGlbSize(static_cast<int>(vertices), static_cast<int>(source.faces->size()), frameCount(), *source.scene));
      } else {
        for (std::size_t i = 0; i < p.size(); ++i) p[i] -= positions.base[i];
        n.resize(normals.base.size());
        for (std::size_t i = 0; i < n.size(); ++i) n[i] -= normals.base[i];
      }
      positions.add(glb, p);
      if (!n.empty()) normals.add(glb, n);
    }
    return {};
  }

  // Accessors into the one view of all frames.
  std::vector<int> addAccessors(FrameAttribute& block, int view) {
    std::vector<int> out;
    for (json& accessor : block.accessors) {
      accessor["bufferView"] = view;
      out.push_back(glb.addAccessor(std::move(accessor)));
    }
    return out;
  }

  // Weights: frame k shows target k - 1 alone, frame 0 the base.
  int addWeights(std::size_t frames, std::size_t targets) {
    if (frames <= kMostDenseFrames) {
      std::vector<float> weights(frames * targets, 0);
      for (std::size_t k = 1; k < frames; ++k) weights[k * targets + k - 1] = 1;
      return glb.addArray(weights, "SCALAR", 1, kFloat);
    }
    std::vector<std::uint32_t> places(frames - 1);
    for (std::size_t k = 1; k < frames; ++k) places[k - 1] = static_cast<std::uint32_t>(k * targets + k - 1);
    const std::vector<float> ones(frames - 1, 1);
    const int placeView = glb.addView(glb.append(places.data(), places.size()));
    const int valueView = glb.addView(glb.append(ones.data(), ones.size()));
    return glb.addAccessor({{"componentType", kFloat}, {"count", frames * targets}, {"type", "SCALAR"},
                            {"sparse", {{"count", places.size()},
                                        {"indices", {{"bufferView", placeView}, {"componentType", kUnsignedInt}}},
                                        {"values", {{"bufferView", valueView}}}}}});
  }

  void addAnimation() {
    if (source.seconds.size() < 2) return;
    const std::vector<float> times(source.seconds.begin(), source.seconds.end());
    const int input = glb.addArray(times, "SCALAR", 1, kFloat);
    glb.doc["accessors"][input]["min"] = {times.front()};
    glb.doc["accessors"][input]["max"] = {times.back()};
    const int output = addWeights(times.size(), frameCount() - 1);
    glb.doc["animations"] = {{{"name", "shapespline"},
                              {"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
  }

  Result<std::vector<std::uint8_t>> write() {
    if (Status times = checkTimes(); !times) return times.error();
    if (Status weights = checkWeights(); !weights) return weights.error();
    if (Status frames = writeFrames(); !frames) return frames.error();
    const int view = glb.addView(0, kArrayBuffer, 12);
    const auto p = addAccessors(positions, view), n = addAccessors(normals, view);
    json attributes = {{"POSITION", p[0]}}, targets = json::array();
    if (!n.empty()) attributes["NORMAL"] = n[0];
    for (std::size_t k = 1; k < p.size(); ++k) {
      targets.push_back({{"POSITION", p[k]}});
      if (!n.empty()) targets.back()["NORMAL"] = n[k];
    }
    LookWriter{glb, *source.scene, {}}.write();
    const Seams& seams = source.scene->seams;
    MeshWriter mesh{glb, seams.copyOf.empty() ? *source.faces : seams.faces, *source.scene, vertices + seams.copyOf.size()};
    mesh.addTangents(attributes, positions.base, normals.base);
    json out = {{"primitives", mesh.primitives(std::move(attributes), targets)}};
    if (!targets.empty()) out["weights"] = std::vector<int>(targets.size(), 0);
    glb.doc["meshes"].push_back(std::move(out));
    glb.doc["nodes"] = {{{"mesh", 0}}};
    glb.doc["scenes"] = {{{"nodes", {0}}}};
    glb.doc["scene"] = 0;
    addAnimation();
    if (!source.project.empty()) {
      json project = json::parse(source.project, nullptr, false);
      if (!project.is_object()) return Error{ErrorCode::InvalidOption, "The project to be saved is not a JSON object."};
      glb.doc["extras"]["shapespline"] = std::move(project);
    }
    return glb.finish();
  }
};

// Seams can only be seen in a texture: without one the file has the mesh's own vertices.
bool hasIdleSeams(const Scene& scene) { return !scene.seams.copyOf.empty() && scene.images.empty(); }

Scene withoutSeams(Scene scene) {
  scene.seams = {};
  scene.uvs.clear();
  return scene;
}

Result<std::vector<std::uint8_t>> write(const AnimationSource& source) {
  if (!hasIdleSeams(*source.scene)) return AnimationWriter{source, {}}.write();
  const Scene scene = withoutSeams(*source.scene);
  AnimationSource plain = source;
  plain.scene = &scene;
  return AnimationWriter{plain, {}}.write();
}

}  // namespace

Result<std::vector<std::uint8_t>> writeAnimatedGlb(const AnimationSource& source) {
  try {
    return write(source);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for this export. Export fewer frames."};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for this export. Export fewer frames."};
  } catch (const nlohmann::json::exception&) {
    return Error{ErrorCode::Internal, "The export could not be described as JSON (a name is not valid text)."};
  }
}

std::uint64_t animatedGlbSize(int vertices, int faces, int frames, const Scene& scene) {
  if (hasIdleSeams(scene)) return animatedGlbSize(vertices, faces, frames, withoutSeams(scene));
  const std::uint64_t copies = scene.seams.copyOf.size(), n = vertices + copies, f = frames;
  const std::uint64_t dense = f * f * 4, sparse = f * 8;
  std::uint64_t size = n * 24 * f + std::uint64_t(faces) * (n <= 0xffff ? 6 : 12) + f * 500 + 2000;
  size += f <= kMostDenseFrames ? dense : sparse;
  size += 4 * (scene.uvs.size() + scene.colors.size() + (copies > 0 ? n : 0));
  const auto mapped = [](const Material& m) { return m.normalImage >= 0; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), mapped)) size += 16 * n;  // tangents
  for (const Image& image : scene.images) size += image.bytes.size();
  return size;
}

Result<std::vector<std::uint8_t>> writePoseGlb(std::span<const float> positions, std::span<const float> normals,
                                               const std::vector<Triangle>& faces, const Scene& scene) {
  AnimationSource source;
  source.faces = &faces;
  source.scene = &scene;
  source.seconds = {0};
  source.frame = [&](int, std::vector<float>& p, std::vector<float>& n) {
    p.assign(positions.begin(), positions.end());
    n.assign(normals.begin(), normals.end());
    return Status();
  };
  return writeAnimatedGlb(source);
}

}  // namespace shapespline
