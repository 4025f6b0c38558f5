// The default scene of a glTF file before any vertex is read: mesh nodes, copies and total size.
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
  std::vector<int> meshNodes;  ///< mesh nodes of the default scene, depth first, visible or not; their meshes exist
};

/// Errors: those of readNodes; MalformedFile for missing meshes; TooLarge for too many morph weights.
Result<GltfScene> readScene(const GltfDocument& doc);

/// The start of a name. Many objects may share a mesh's name, so long names could grow to gigabytes.
std::string_view shortName(std::string_view name, std::size_t most = 256);

/// Display name of a mesh node: the node's name or its mesh's name, shortened.
std::string objectName(const GltfDocument& doc, int node);

/// The distinct names of mesh nodes.
std::vector<std::string> objectNames(const GltfDocument& doc, const std::vector<int>& nodes);

/// The nodes with one of these names, or all nodes if the list is empty.
std::vector<int> namedNodes(const GltfDocument& doc, std::vector<int> nodes, const std::vector<std::string>& wanted);

/// Filters the visible nodes, given each node's own visibility.
std::vector<int> visibleNodes(const GltfScene& scene, std::vector<int> nodes, const std::vector<char>& visible);

/// Number of copies of the mesh at a node (EXT_mesh_gpu_instancing), 1 without the extension. A skinned mesh has one,
/// because skins move all copies to the same position.
std::size_t instanceCount(const GltfDocument& doc, int node);

/// Transforms of the copies relative to their node. Error: MalformedFile.
Result<std::vector<Eigen::Affine3d>> readInstances(const GltfDocument& doc, int node);

/// Most faces of a scene, several times those of the largest tested mesh.
constexpr std::int64_t maxFaces = 32'000'000;

/// Error for a scene that exceeds a limit.
Error tooLarge(const GltfDocument& doc, std::int64_t most, const char* what);

/// Number of keys, and how many of them the file requests.
struct KeyCount {
  std::size_t all = 1, ofFile = 1;
};

/// Counts vertices, weights and corners of these nodes for this number of keys. Error: TooLarge beyond fixed limits or
/// limits that depend on the file size. Nodes, instances and targets may repeat a few bytes many times.
Status checkAmount(const GltfDocument& doc, const std::vector<int>& meshNodes, KeyCount keys);

bool isTriangles(int mode);

/// Number of morph targets of a mesh.
int targetCount(const tinygltf::Mesh& mesh);

/// Orders primitives by their vertex accessors.
struct ByVertices {
  bool operator()(const tinygltf::Primitive* a, const tinygltf::Primitive* b) const {
    return a->attributes != b->attributes ? a->attributes < b->attributes : a->targets < b->targets;
  }
};

}  // namespace shapespline
