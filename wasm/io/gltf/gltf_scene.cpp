#include "io/gltf/gltf_scene.h"

#include <algorithm>
#include <set>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/limits.h"
#include "io/base/objects.h"
#include "io/base/sample_times.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

// Limit for Amount::inKeys: `small` for any file, plus `perByte` for each byte of the file.
constexpr std::uint64_t small = 1'000'000, perByte = 16;

// Limits for primitives of all mesh nodes and morph weights of all nodes, far above real scenes.
constexpr std::int64_t maxParts = 100'000, maxWeights = 10'000'000;

// Declared sizes of a mesh.
struct Amount {
  std::uint64_t vertices = 0, corners = 0, weights = 0;

  // Cost until the first shape is ready, in units of reading a vertex. Includes encoding the keys and assembling the
  // systems from corners.
  std::uint64_t inKeys(std::size_t keys) const { return vertices * (4 * keys + 1) + 3 * corners + weights; }
};

std::size_t countOf(const GltfDocument& doc, const tinygltf::Primitive& primitive, const std::string& attribute) {
  const auto found = primitive.attributes.find(attribute);
  return found == primitive.attributes.end() ? 0 : accessorCount(doc, found->second);
}

Amount amountOf(const GltfDocument& doc, const tinygltf::Mesh& mesh) {
  Amount amount;
  std::set<const tinygltf::Primitive*, ByVertices> known;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!isTriangles(primitive.mode)) continue;
    const std::size_t count = countOf(doc, primitive, "POSITION");
    amount.corners += primitive.indices < 0 ? count : accessorCount(doc, primitive.indices);
    if (!known.insert(&primitive).second) continue;
    amount.vertices += count;
    for (const auto& [name, accessor] : primitive.attributes)
      if (name.starts_with("WEIGHTS_")) amount.weights += 4 * accessorCount(doc, accessor);
  }
  return amount;
}

const tinygltf::Value* instancing(const GltfDocument& doc, int node) {
  const auto& extensions = doc.model.nodes[node].extensions;
  const auto found = extensions.find("EXT_mesh_gpu_instancing");
  if (found == extensions.end() || doc.model.nodes[node].skin >= 0 || !found->second.Has("attributes")) return nullptr;
  return &found->second.Get("attributes");
}

// The accessor of an instance attribute, or -1.
int instanceAttribute(const tinygltf::Value& attributes, const char* name) {
  return attributes.Has(name) && attributes.Get(name).IsInt() ? attributes.Get(name).Get<int>() : -1;
}

Error tooMuch(const GltfDocument& doc, const Amount& all, std::size_t keys) {
  const bool isOfFaces = 3 * all.corners > all.vertices * keys;
  const std::string faces =
      isOfFaces ? " and " + grouped(static_cast<std::int64_t>(all.corners / 3)) + " faces" : std::string();
  return {ErrorCode::TooLarge, doc.where + " shows " + grouped(static_cast<std::int64_t>(all.vertices)) + " vertices" +
                                   faces +
                                   (keys == 1 ? "" : " in " + grouped(static_cast<std::int64_t>(keys)) + " keys") +
                                   ", more than is supported for a file of " + sizeText(doc.fileBytes) +
                                   ". Export fewer copies of its meshes, or fewer morph targets."};
}

// Every node has its own weights for its mesh's targets.
Status countWeights(const GltfDocument& doc) {
  std::vector<int> targetCounts;
  for (const tinygltf::Mesh& mesh : doc.model.meshes) targetCounts.push_back(targetCount(mesh));
  std::int64_t weights = 0;
  for (const tinygltf::Node& node : doc.model.nodes) {
    const bool hasMesh = node.mesh >= 0 && node.mesh < static_cast<int>(doc.model.meshes.size());
    if (hasMesh) weights += targetCounts[node.mesh];
    weights += static_cast<std::int64_t>(
        std::max(node.weights.size(), hasMesh ? doc.model.meshes[node.mesh].weights.size() : 0));
    if (weights > maxWeights) return tooLarge(doc, maxWeights, "morph weights");
  }
  return {};
}

}  // namespace

Result<GltfScene> readScene(const GltfDocument& doc) {
  if (Status weights = countWeights(doc); !weights) return weights.error();
  auto graph = readNodes(doc);
  if (!graph) return graph.error();
  GltfScene scene{std::move(*graph), {}};
  for (int node : scene.graph.shown) {
    const int mesh = doc.model.nodes[node].mesh;
    if (mesh < 0) continue;
    if (mesh >= static_cast<int>(doc.model.meshes.size()))
      return malformed(
          doc.where, "node " + std::to_string(node) + " shows mesh " + std::to_string(mesh) + ", which does not exist");
    if (const std::string broken = brokenPart(doc.model.meshes[mesh].extras); !broken.empty())
      return malformed(doc.where, "mesh " + std::to_string(mesh) + broken);
    scene.meshNodes.push_back(node);
  }
  return scene;
}

std::string_view shortName(std::string_view name, std::size_t most) {
  if (name.size() <= most) return name;
  while (most > 0 && (name[most] & 0xc0) == 0x80) --most;  // never inside a UTF-8 character
  return name.substr(0, most);
}

std::string objectName(const GltfDocument& doc, int node) {
  const tinygltf::Node& at = doc.model.nodes[node];
  const std::string& mesh = doc.model.meshes[at.mesh].name;
  const std::string& name = at.name.empty() ? mesh : at.name;
  return name.empty() ? "mesh " + std::to_string(at.mesh) : std::string(shortName(name));
}

std::vector<std::string> objectNames(const GltfDocument& doc, const std::vector<int>& nodes) {
  std::vector<std::string> names;
  for (int node : nodes) addObject(objectName(doc, node), names);
  return names;
}

std::vector<int> namedNodes(const GltfDocument& doc, std::vector<int> nodes, const std::vector<std::string>& wanted) {
  std::erase_if(nodes, [&](int node) { return !takesObject(wanted, objectName(doc, node)); });
  return nodes;
}

std::vector<int> visibleNodes(const GltfScene& scene, std::vector<int> nodes, const std::vector<char>& visible) {
  const std::vector<char> seen = seenNodes(scene.graph, visible);
  std::erase_if(nodes, [&](int node) { return !seen[node]; });
  return nodes;
}

std::size_t instanceCount(const GltfDocument& doc, int node) {
  const tinygltf::Value* attributes = instancing(doc, node);
  if (!attributes) return 1;
  std::size_t count = 0;
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
    count = std::max(count, accessorCount(doc, instanceAttribute(*attributes, name)));
  return std::max<std::size_t>(count, 1);
}

Result<std::vector<Eigen::Affine3d>> readInstances(const GltfDocument& doc, int node) {
  const std::size_t count = instanceCount(doc, node);
  std::vector<NodeTransform> parts(count);
  const tinygltf::Value* attributes = instancing(doc, node);
  const auto read = [&](const char* name, int width, auto set) -> Status {
    const int accessor = attributes ? instanceAttribute(*attributes, name) : -1;
    if (accessor < 0) return {};
    const std::string what = std::string("instance ") + name + " of node " + std::to_string(node);
    if (accessorCount(doc, accessor) != count)
      return malformed(doc.where, what + " does not have as many elements as its other attributes");
    const auto numbers = readNumbers(doc, accessor, width, what);
    if (!numbers) return numbers.error();
    for (std::size_t i = 0; i < count; ++i) set(parts[i], &(*numbers)[width * i]);
    return {};
  };
  Status status =
      read("TRANSLATION", 3, [](NodeTransform& part, const double* value) { part.translation = Vec3(value); });
  if (status) status = read("SCALE", 3, [](NodeTransform& part, const double* value) { part.scale = Vec3(value); });
  if (status)
    status = read("ROTATION", 4, [](NodeTransform& part, const double* value) {
      const Eigen::Quaterniond q(value);
      if (q.norm() > 0) part.rotation = q.normalized();
    });
  if (!status) return status.error();
  std::vector<Eigen::Affine3d> out;
  for (const NodeTransform& part : parts) out.push_back(part.affine());
  return out;
}

Error tooLarge(const GltfDocument& doc, std::int64_t most, const char* what) {
  return {ErrorCode::TooLarge,
          doc.where + " exceeds the limit of " + grouped(most) + " " + what + ". Simplify the mesh first."};
}

Status checkAmount(const GltfDocument& doc, const std::vector<int>& meshNodes, KeyCount keys) {
  std::vector<Amount> amounts;
  for (const tinygltf::Mesh& mesh : doc.model.meshes) amounts.push_back(amountOf(doc, mesh));
  Amount all;
  std::uint64_t parts = 0;
  for (int node : meshNodes) {
    const std::uint64_t copies = instanceCount(doc, node);
    const Amount& mesh = amounts[doc.model.nodes[node].mesh];
    // Each count is below 2^31, so no product overflows.
    parts += copies * doc.model.meshes[doc.model.nodes[node].mesh].primitives.size();
    if (parts > static_cast<std::uint64_t>(maxParts)) return tooLarge(doc, maxParts, "mesh primitives");
    all.vertices += copies * mesh.vertices;
    all.corners += copies * mesh.corners;
    all.weights += copies * mesh.weights;
    if (all.vertices > maxElements) return tooLarge(doc, maxElements, "vertices");
    if (all.corners > 3 * static_cast<std::uint64_t>(maxFaces)) return tooLarge(doc, maxFaces, "faces");
    if (all.weights > 4 * maxElements) return tooLarge(doc, 4 * maxElements, "joint weights");
  }
  if (Status count = checkKeyCount(keys.all, all.vertices, doc.where); !count) return count;
  if (all.inKeys(keys.ofFile) > small + perByte * doc.fileBytes) return tooMuch(doc, all, keys.ofFile);
  return {};
}

bool isTriangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

int targetCount(const tinygltf::Mesh& mesh) {
  std::size_t most = 0;
  for (const tinygltf::Primitive& primitive : mesh.primitives) most = std::max(most, primitive.targets.size());
  return static_cast<int>(most);
}

}  // namespace shapespline
