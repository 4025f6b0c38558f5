// Poses and motions as GLB. The JSON is put together here: tinygltf's serializer would want every byte twice.
#include "io/gltf/gltf_writer.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "io/base/limits.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/gltf_mesh_writer.h"

namespace shapespline {

namespace {

using nlohmann::json;

// Up to here the one-hot weight matrix (frames x targets floats, 4 MB at most) is written out, because every reader
// understands that; beyond, as a sparse accessor, which grows with the frames instead of their square.
constexpr std::size_t kMostDenseFrames = 1024;

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
      return Error{ErrorCode::NotFinite,
                   "Frame " + std::to_string(frame) + " has a vertex that is not finite (" +
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
    for (std::size_t k = 1; k < t.size(); ++k)
      increasing = increasing && static_cast<float>(t[k]) > static_cast<float>(t[k - 1]);
    if (increasing) return {};
    return Error{ErrorCode::InvalidOption,
                 "The exported times must start at 0 and increase. Use a longer duration or fewer frames."};
  }

  Status checkWeights() const {
    const std::uint64_t weights = source.seconds.size() * static_cast<std::uint64_t>(frameCount() - 1);
    if (weights <= kMostElements) return {};
    return Error{ErrorCode::TooLarge, "An animation with " + grouped(std::int64_t(frameCount() - 1)) +
                                          " morph targets needs " + grouped(std::int64_t(weights)) +
                                          " weights, one for each at every frame; with more than " +
                                          grouped(std::int64_t(kMostElements)) +
                                          " the file could not be opened again. Export fewer frames."};
  }

  Status readFrame(int k, std::vector<float>& p, std::vector<float>& n) {
    if (Status frame = source.frame(k, p, n); !frame) return frame;
    if (k == 0) vertices = p.size() / 3;
    if (p.empty() || p.size() != 3 * vertices || (!n.empty() && n.size() != p.size()))
      return Error{ErrorCode::Internal, "Frame " + std::to_string(k) + " has a different number of vertices."};
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
        glb.bin.reserve(animatedGlbSize(static_cast<int>(vertices), static_cast<int>(source.faces->size()),
                                        frameCount(), *source.scene));
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
    return glb.addAccessor({{"componentType", kFloat},
                            {"count", frames * targets},
                            {"type", "SCALAR"},
                            {"sparse",
                             {{"count", places.size()},
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
    writeLook(glb, *source.scene);
    const Seams& seams = source.scene->seams;
    MeshWriter mesh{glb, seams.copyOf.empty() ? *source.faces : seams.faces, *source.scene,
                    vertices + seams.copyOf.size()};
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
