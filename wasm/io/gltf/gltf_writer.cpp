// Poses and motions as GLB. The JSON is assembled here because tinygltf's serializer would hold every byte twice.
#include "io/gltf/gltf_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/format.h"
#include "io/base/finite_shape.h"
#include "io/base/limits.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/gltf_mesh_writer.h"

namespace shapespline {

namespace {

using nlohmann::json;

// Up to this number of frames, the one-hot weight matrix (frames x targets floats, at most 4 MB) is written in full,
// which every reader understands. For more frames, a sparse accessor grows linearly instead of quadratically.
constexpr std::size_t maxDenseFrames = 1024;

json boundsOf(const std::vector<float>& values) {
  float low[3] = {values[0], values[1], values[2]}, high[3] = {values[0], values[1], values[2]};
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], values[i]);
    high[i % 3] = std::max(high[i % 3], values[i]);
  }
  return {{"min", low}, {"max", high}};
}

// The frames of one primitive in a buffer view: the base, followed by the differences of every target.
struct PrimitiveFrames {
  DrawnPrimitive drawn;
  std::size_t start = 0, next = 0;  // offset in the view, and offset of the next frame
  std::vector<json> positions{}, normals{};

  void add(GlbBuilder& glb, std::span<const float> ofMesh, std::vector<json>& accessors, bool bounded) {
    const std::vector<float> values = gathered(ofMesh, 3, drawn);
    json accessor = {
        {"byteOffset", next - start}, {"componentType", glFloat}, {"count", values.size() / 3}, {"type", "VEC3"}};
    if (bounded) accessor.update(boundsOf(values));  // glTF requires bounds for POSITION
    accessors.push_back(std::move(accessor));
    std::memcpy(glb.bin.data() + next, values.data(), values.size() * sizeof(float));
    next += values.size() * sizeof(float);
  }
};

// Normalises. If a vertex has no normal, because its faces are degenerate, any unit vector is written.
void makeUnit(std::vector<float>& normals) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const double x = normals[i], y = normals[i + 1], z = normals[i + 2], length = std::sqrt(x * x + y * y + z * z);
    const bool usable = length > 1e-6 && std::isfinite(length);
    normals[i] = usable ? static_cast<float>(x / length) : 0;
    normals[i + 1] = usable ? static_cast<float>(y / length) : 0;
    normals[i + 2] = usable ? static_cast<float>(z / length) : 1;
  }
}

struct AnimationWriter {
  const AnimationSource& source;
  GlbBuilder glb;
  std::size_t vertices = 0;                         // number of mesh vertices
  std::vector<float> firstShape{}, firstNormals{};  // values of drawn vertices
  std::vector<PrimitiveFrames> primitives{};

  const Seams& seams() const { return source.scene->seams; }
  const std::vector<Triangle>& drawnFaces() const { return seams().copyOf.empty() ? *source.faces : seams().faces; }
  std::size_t drawnVertices() const { return vertices + seams().copyOf.size(); }

  int frameCount() const { return source.shapes(); }

  Status checkTimes() const {
    const auto& t = source.seconds;
    bool increasing = !t.empty() && t[0] == 0;
    for (std::size_t k = 1; k < t.size(); ++k)
      increasing = increasing && static_cast<float>(t[k]) > static_cast<float>(t[k - 1]);
    const std::size_t weights = source.seconds.size() * static_cast<std::size_t>(frameCount() - 1);
    if (!source.weights.empty() && source.weights.size() != weights)
      return Error{ErrorCode::Internal, "There must be one weight for each target at every time."};
    if (increasing) return {};
    return Error{ErrorCode::InvalidOption,
                 "The exported times must start at 0 and increase. Use a longer duration or fewer frames."};
  }

  Status checkWeights() const {
    const std::uint64_t weights = source.seconds.size() * static_cast<std::uint64_t>(frameCount() - 1);
    if (weights <= maxElements) return {};
    return Error{ErrorCode::TooLarge, "An animation with " + grouped(std::int64_t(frameCount() - 1)) +
                                          " morph targets needs " + grouped(std::int64_t(weights)) +
                                          " weights, one per target and frame. With more than " +
                                          grouped(std::int64_t(maxElements)) +
                                          " weights, the file could not be opened again. Export fewer frames."};
  }

  Status readFrame(int k, std::vector<float>& p, std::vector<float>& n) {
    if (Status frame = source.frame(k, p, n); !frame) return frame;
    if (k == 0) vertices = p.size() / 3;
    if (p.empty() || p.size() != 3 * vertices || (!n.empty() && n.size() != p.size()))
      return Error{ErrorCode::Internal, "Frame " + std::to_string(k) + " has a different number of vertices."};
    if (Status finite = checkFinite(p, k); !finite) return finite;
    if (k == 0 || source.weights.empty()) makeUnit(n);
    addCopies(source.scene->seams, 3, p);
    addCopies(source.scene->seams, 3, n);
    return {};
  }

  // Frames arrive one by one, but their sizes are known, so each primitive's frames are stored contiguously.
  void divide() {
    for (DrawnPrimitive& drawn : drawnPrimitives(drawnFaces(), static_cast<int>(drawnVertices()), *source.scene))
      primitives.push_back({std::move(drawn)});
    const std::size_t bytes = (firstNormals.empty() ? 12 : 24) * static_cast<std::size_t>(frameCount());
    std::size_t end = 0;
    for (PrimitiveFrames& p : primitives) {
      p.start = p.next = end;
      end += bytes * p.drawn.vertices.size();
    }
    glb.bin.reserve(animatedGlbSize(*source.faces, static_cast<int>(vertices), frameCount(), *source.scene).bytes);
    glb.bin.resize(end);
  }

  // Requests each frame once and never keeps it.
  Status writeFrames() {
    std::vector<float> p, n;
    for (int k = 0; k < frameCount(); ++k) {
      if (Status frame = readFrame(k, p, n); !frame) return frame;
      if (k == 0) {
        firstShape = p;
        firstNormals = n;
        divide();
      } else {
        n.resize(firstNormals.size());
        for (std::size_t i = 0; i < p.size(); ++i) p[i] -= firstShape[i];
        for (std::size_t i = 0; i < n.size(); ++i) n[i] -= firstNormals[i];
      }
      for (PrimitiveFrames& primitive : primitives) {
        primitive.add(glb, p, primitive.positions, true);
        if (!n.empty()) primitive.add(glb, n, primitive.normals, false);
      }
    }
    return {};
  }

  // Attributes of one frame: accessor indices into the primitive's view.
  json attributesOf(PrimitiveFrames& primitive, std::size_t frame, int view) {
    json out;
    const auto add = [&](const char* name, std::vector<json>& accessors) {
      if (accessors.empty()) return;
      accessors[frame]["bufferView"] = view;
      out[name] = glb.addAccessor(std::move(accessors[frame]));
    };
    add("POSITION", primitive.positions);
    add("NORMAL", primitive.normals);
    return out;
  }

  json addPrimitive(MeshWriter& mesh, PrimitiveFrames& primitive) {
    json view = {{"buffer", 0},
                 {"byteOffset", primitive.start},
                 {"byteLength", primitive.next - primitive.start},
                 {"target", glArrayBuffer},
                 {"byteStride", 12}};
    glb.doc["bufferViews"].push_back(std::move(view));
    const int index = static_cast<int>(glb.doc["bufferViews"].size()) - 1;
    json out = mesh.primitive(primitive.drawn, attributesOf(primitive, 0, index));
    for (std::size_t k = 1; k < static_cast<std::size_t>(frameCount()); ++k)
      out["targets"].push_back(attributesOf(primitive, k, index));
    return out;
  }

  json addMesh() {
    MeshWriter mesh(glb, drawnFaces(), *source.scene, drawnVertices());
    mesh.makeTangents(firstShape, firstNormals);
    if (!seams().copyOf.empty() || primitives.size() > 1 || !source.project.empty()) mesh.makeVertexNumbers();
    json out = {{"primitives", json::array()}};
    if (!source.name.empty()) out["name"] = source.name;
    for (PrimitiveFrames& primitive : primitives) out["primitives"].push_back(addPrimitive(mesh, primitive));
    if (frameCount() == 1) return out;
    out["weights"] = std::vector<int>(frameCount() - 1, 0);
    // Blender, three.js and Babylon.js read target names from this key.
    if (source.targetNames.size() + 1 == static_cast<std::size_t>(frameCount()))
      out["extras"]["targetNames"] = source.targetNames;
    return out;
  }

  // By default, frame 0 shows the base and frame k shows target k - 1 alone.
  int addWeights(std::size_t frames, std::size_t targets) {
    if (!source.weights.empty()) return glb.addArray(source.weights, "SCALAR", 1, glFloat);
    if (frames <= maxDenseFrames) {
      std::vector<float> weights(frames * targets, 0);
      for (std::size_t k = 1; k < frames; ++k) weights[k * targets + k - 1] = 1;
      return glb.addArray(weights, "SCALAR", 1, glFloat);
    }
    std::vector<std::uint32_t> places(frames - 1);
    for (std::size_t k = 1; k < frames; ++k) places[k - 1] = static_cast<std::uint32_t>(k * targets + k - 1);
    const std::vector<float> ones(frames - 1, 1);
    const int placeView = glb.addView(glb.append(places.data(), places.size()));
    const int valueView = glb.addView(glb.append(ones.data(), ones.size()));
    return glb.addAccessor({{"componentType", glFloat},
                            {"count", frames * targets},
                            {"type", "SCALAR"},
                            {"sparse",
                             {{"count", places.size()},
                              {"indices", {{"bufferView", placeView}, {"componentType", glUnsignedInt}}},
                              {"values", {{"bufferView", valueView}}}}}});
  }

  void addAnimation() {
    if (source.seconds.size() < 2) return;
    const std::vector<float> times(source.seconds.begin(), source.seconds.end());
    const int input = glb.addArray(times, "SCALAR", 1, glFloat);
    glb.doc["accessors"][input]["min"] = {times.front()};
    glb.doc["accessors"][input]["max"] = {times.back()};
    const int output = addWeights(times.size(), frameCount() - 1);
    glb.doc["animations"] = {{{"name", source.clip.empty() ? "shapespline" : source.clip},
                              {"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
  }

  Result<std::vector<std::uint8_t>> write() {
    if (Status times = checkTimes(); !times) return times.error();
    if (Status weights = checkWeights(); !weights) return weights.error();
    if (Status frames = writeFrames(); !frames) return frames.error();
    writeLook(glb, *source.scene);
    glb.doc["meshes"].push_back(addMesh());
    json node = {{"mesh", 0}};
    if (!source.name.empty()) node["name"] = source.name;
    if (source.offset != Vec3::Zero()) node["translation"] = {source.offset.x(), source.offset.y(), source.offset.z()};
    glb.doc["nodes"].push_back(std::move(node));
    glb.doc["scenes"] = {{{"nodes", {0}}}};
    glb.doc["scene"] = 0;
    addAnimation();
    if (!source.project.empty()) {
      const char* text = source.project.data();
      json project = json::parse(text, text + source.project.size(), nullptr, false);
      if (!project.is_object()) return Error{ErrorCode::InvalidOption, "The project to save is not a JSON object."};
      glb.doc["extras"]["shapespline"] = std::move(project);
    }
    return glb.finish();
  }
};

}  // namespace

Result<std::vector<std::uint8_t>> writeAnimatedGlb(const AnimationSource& source) {
  try {
    return AnimationWriter{source, {}}.write();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for this export. Export fewer frames."};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for this export. Export fewer frames."};
  } catch (const nlohmann::json::exception&) {
    return Error{ErrorCode::Internal, "The export could not be written as JSON because a name is not valid text."};
  }
}

GlbSize animatedGlbSize(const std::vector<Triangle>& faces, int vertices, int frames, const Scene& scene) {
  const bool seams = !scene.seams.copyOf.empty();
  const int drawn = vertices + static_cast<int>(scene.seams.copyOf.size());
  const auto primitives = drawnPrimitives(seams ? scene.seams.faces : faces, drawn, scene);
  const std::uint64_t f = frames, dense = f * f * 4, sparse = f * 8;
  GlbSize size;
  size.bytes = 2000 + f * 20 + (f <= maxDenseFrames ? dense : sparse);
  for (const DrawnPrimitive& primitive : primitives) {
    const std::uint64_t n = primitive.vertices.size();
    size.vertices += n;
    size.bytes += n * 24 * f + primitive.faces.size() * (n <= 0xffff ? 6 : 12) + f * 480;
  }
  const std::uint64_t perVertex = 4 + (seams ? 4 : 0) + (scene.uvs.empty() ? 0 : 8) + (scene.colors.empty() ? 0 : 16);
  size.bytes += perVertex * size.vertices;
  const auto mapped = [](const Material& m) { return m.normalImage >= 0; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), mapped))
    size.bytes += 16 * size.vertices;  // size of the tangents
  for (const Image& image : scene.images) size.bytes += image.bytes.size();
  return size;
}

Result<std::vector<std::uint8_t>> writePoseGlb(std::span<const float> positions, std::span<const float> normals,
                                               const std::vector<Triangle>& faces, const Scene& scene,
                                               const Vec3& offset) {
  AnimationSource source;
  source.offset = offset;
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
