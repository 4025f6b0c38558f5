// Makes glTF files for the tests. Editing `doc` makes broken ones.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/types.h"
#include "files.h"

namespace shapespline::test {

using nlohmann::json;

inline std::string base64(const Bytes& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (i + k < bytes.size() ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

inline std::string dataUri(const Bytes& bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

/// A GLB from its parts, with correct headers.
inline Bytes glbFrom(std::string text, const Bytes& bin) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  Bytes out = bytesOf("glTF");
  const auto word = [&](std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
  };
  const std::size_t padded = (bin.size() + 3) / 4 * 4;
  word(2), word(12 + 8 + text.size() + (bin.empty() ? 0 : 8 + padded));
  word(text.size()), word(0x4E4F534A);
  out.insert(out.end(), text.begin(), text.end());
  if (bin.empty()) return out;
  word(padded), word(0x004E4942);
  out.insert(out.end(), bin.begin(), bin.end());
  out.resize(out.size() + padded - bin.size());
  return out;
}

/// Component types of accessors.
enum : int { glInt8 = 5120, glUInt8 = 5121, glInt16 = 5122, glUInt16 = 5123, glUInt32 = 5125, glFloat32 = 5126 };

struct GltfMaker {
  json doc = {{"asset", {{"version", "2.0"}}},
              {"scene", 0},
              {"scenes", {{{"nodes", json::array()}}}},
              {"nodes", json::array()}};
  Bytes bin;

  int add(const char* collection, json item) {
    doc[collection].push_back(std::move(item));
    return static_cast<int>(doc[collection].size()) - 1;
  }

  template <class T>
  int view(const std::vector<T>& values, int stride = 0) {
    bin.resize((bin.size() + 3) / 4 * 4);
    const std::size_t start = bin.size();
    bin.resize(start + values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(bin.data() + start, values.data(), values.size() * sizeof(T));
    json out = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", bin.size() - start}};
    if (stride) out["byteStride"] = stride;
    return add("bufferViews", out);
  }

  template <class T>
  int accessor(const std::vector<T>& values, const char* type, int components, int componentType,
               bool normalised = false) {
    json out = {{"bufferView", view(values)},
                {"componentType", componentType},
                {"count", values.size() / components},
                {"type", type}};
    if (normalised) out["normalized"] = true;
    return add("accessors", out);
  }

  int vectors(const Positions& points) {
    std::vector<float> values;
    for (const Vec3& p : points)
      for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(p[c]));
    return accessor(values, "VEC3", 3, glFloat32);
  }

  int scalars(const std::vector<float>& values) { return accessor(values, "SCALAR", 1, glFloat32); }

  int indices(const std::vector<Triangle>& faces) {
    std::vector<std::uint16_t> values;
    for (const Triangle& f : faces) values.insert(values.end(), f.begin(), f.end());
    return accessor(values, "SCALAR", 1, glUInt16);
  }

  /// A mesh of one primitive, with the given attributes and optional indices.
  int mesh(json attributes, int indexAccessor = -1, json targets = json::array()) {
    json primitive = {{"attributes", std::move(attributes)}};
    if (indexAccessor >= 0) primitive["indices"] = indexAccessor;
    if (!targets.empty()) primitive["targets"] = std::move(targets);
    return add("meshes", {{"primitives", {primitive}}});
  }

  /// A node shown at the root of the scene.
  int node(json item) {
    const int index = add("nodes", std::move(item));
    doc["scenes"][0]["nodes"].push_back(index);
    return index;
  }

  /// An animation with one channel.
  int animation(const std::string& name, int target, const char* path, int times, int values,
                const char* interpolation = "LINEAR") {
    return add("animations", {{"name", name},
                              {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", target}, {"path", path}}}}}}});
  }

  json withBuffer() const {
    json out = doc;
    if (!bin.empty() && !out.contains("buffers")) out["buffers"] = {{{"byteLength", bin.size()}}};
    return out;
  }

  Bytes glb() const { return glbFrom(withBuffer().dump(), bin); }

  /// A .gltf file with an embedded buffer.
  Bytes gltf() const {
    json out = withBuffer();
    if (!bin.empty()) out["buffers"][0]["uri"] = dataUri(bin);
    return bytesOf(out.dump());
  }

  /// A .gltf file with an external buffer.
  Bytes gltfBeside(const std::string& uri) const {
    json out = withBuffer();
    out["buffers"][0]["uri"] = uri;
    return bytesOf(out.dump());
  }
};

/// A box of 8 vertices and 12 faces, without any corners to weld. `bend` moves its top sideways.
inline Positions boxPose(double bend = 0) {
  Positions out;
  for (int i = 0; i < 8; ++i)
    out.push_back({double(i & 1) + (i & 4 ? bend : 0), double(i >> 1 & 1), 2.0 * (i >> 2 & 1)});
  return out;
}

inline const std::vector<Triangle>& boxFaces() {
  static const std::vector<Triangle> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return faces;
}

inline Positions difference(const Positions& to, const Positions& from) {
  Positions out;
  for (std::size_t i = 0; i < to.size(); ++i) out.push_back(to[i] - from[i]);
  return out;
}

/// A GLB with the box in one pose.
inline GltfMaker boxFile(double bend = 0) {
  GltfMaker maker;
  const int positions = maker.vectors(boxPose(bend)), indices = maker.indices(boxFaces());
  maker.node({{"mesh", maker.mesh({{"POSITION", positions}}, indices)}});
  return maker;
}

/// The box with one morph target for each bend except the first.
inline GltfMaker morphFile(const std::vector<double>& bends) {
  GltfMaker maker;
  const Positions base = boxPose(bends[0]);
  const int positions = maker.vectors(base), indices = maker.indices(boxFaces());
  json targets = json::array();
  for (std::size_t k = 1; k < bends.size(); ++k)
    targets.push_back({{"POSITION", maker.vectors(difference(boxPose(bends[k]), base))}});
  maker.node({{"mesh", maker.mesh({{"POSITION", positions}}, indices, targets)}});
  return maker;
}

inline double distance(const Positions& a, const Positions& b) {
  if (a.size() != b.size()) return 1e300;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

}  // namespace shapespline::test
