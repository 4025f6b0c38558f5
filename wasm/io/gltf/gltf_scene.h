// What the default scene of a glTF file shows, before a vertex is read: its mesh nodes, their copies, and how much all
// of that is.
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

/// The start of a name: many objects may have the name of one mesh, so that long ones would become gigabytes.
std::string_view shortName(std::string_view name, std::size_t most = 256);

/// What the user calls a mesh node: its own name, else its mesh's, shortened.
std::string objectName(const GltfDocument& doc, int node);

/// The names of mesh nodes, each once.
std::vector<std::string> objectNames(const GltfDocument& doc, const std::vector<int>& nodes);

/// Those that have one of these names; all of them where none is wanted.
std::vector<int> namedNodes(const GltfDocument& doc, std::vector<int> nodes, const std::vector<std::string>& wanted);

/// Those that are visible, where each node itself is as `visible` says.
std::vector<int> visibleNodes(const GltfScene& scene, std::vector<int> nodes, const std::vector<char>& visible);

/// Of a node's copies of its mesh (EXT_mesh_gpu_instancing): 1 without the extension. Skins place each copy alike, so
/// that there is one.
std::size_t instanceCount(const GltfDocument& doc, int node);

/// Where the copies stand, seen from the node. Error: MalformedFile.
Result<std::vector<Eigen::Affine3d>> readInstances(const GltfDocument& doc, int node);

/// Several times the largest mesh that the method has been run on.
constexpr std::int64_t kMostFaces = 32'000'000;

/// More of what a scene shows than is supported.
Error tooLarge(const GltfDocument& doc, std::int64_t most, const char* what);

/// How many keys there will be, and how many of them the file itself asks for.
struct KeyCount {
  std::size_t all = 1, ofFile = 1;
};

/// Counts vertices, weights and corners of these nodes in so many keys. Errors: TooLarge where that is more than is
/// supported, or more than a file of this size should become: nodes, instances and targets may repeat what a few bytes
/// hold.
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
