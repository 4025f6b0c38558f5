// The default scene of a glTF file before any vertex is read: its mesh nodes, their copies and the total size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_nodes.h"

namespace shapespline {

struct GltfScene {
  NodeGraph graph;
  std::vector<int> meshNodes;  ///< of the default scene, depth first, visible or not; their meshes exist
};

/// Errors: of readNodes, MalformedFile for meshes that are not there, TooLarge for more morph weights than are
/// supported.
Result<GltfScene> readScene(const GltfDocument& doc);

/// The start of a name: many objects may share the name of a mesh, so long names would grow to gigabytes.
std::string_view shortName(std::string_view name, std::size_t most = 256);

/// Display name of a mesh node: its own name, or that of its mesh, shortened.
std::string objectName(const GltfDocument& doc, int node);

/// The names of mesh nodes, each once.
std::vector<std::string> objectNames(const GltfDocument& doc, const std::vector<int>& nodes);

/// The nodes with one of these names; all nodes if the list is empty.
std::vector<int> namedNodes(const GltfDocument& doc, std::vector<int> nodes, const std::vector<std::string>& wanted);

/// The nodes that are visible, given each node's own visibility.
std::vector<int> visibleNodes(const GltfScene& scene, std::vector<int> nodes, const std::vector<char>& visible);

/// Number of a node's copies of its mesh (EXT_mesh_gpu_instancing); 1 without the extension. Skins place all copies
/// alike, so a skinned mesh has one.
std::size_t instanceCount(const GltfDocument& doc, int node);

/// Transforms of the copies relative to the node. Error: MalformedFile.
Result<std::vector<Eigen::Affine3d>> readInstances(const GltfDocument& doc, int node);

/// Several times the largest mesh that the method has been run on.
constexpr std::int64_t mostFaces = 32'000'000;

/// Error for a scene that exceeds a limit.
Error tooLarge(const GltfDocument& doc, std::int64_t most, const char* what);

/// How many keys there will be, and how many of them the file itself asks for.
struct KeyCount {
  std::size_t all = 1, ofFile = 1;
};

/// Counts vertices, weights and corners of these nodes for this number of keys. Errors: TooLarge if they exceed a
/// limit, or what a file of this size may become: nodes, instances and targets may repeat a few bytes.
Status checkAmount(const GltfDocument& doc, const std::vector<int>& meshNodes, KeyCount keys);

bool isTriangles(int mode);

/// Number of morph targets of a mesh.
int targetCount(const tinygltf::Mesh& mesh);

/// Orders primitives by the vertices that they are made of.
struct ByVertices {
  bool operator()(const tinygltf::Primitive* a, const tinygltf::Primitive* b) const {
    return a->attributes != b->attributes ? a->attributes < b->attributes : a->targets < b->targets;
  }
};

}  // namespace shapespline
