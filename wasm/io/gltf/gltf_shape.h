// All triangles of a glTF scene as one mesh: parts, faces and skins.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/base/types.h"
#include "core/base/warning.h"
#include "io/base/scene.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_nodes.h"
#include "io/gltf/gltf_scene.h"

namespace shapespline {

/// Vertices of one primitive (or of several that share their attributes) of one mesh node, before any transform.
struct GltfPart {
  int node = -1, mesh = -1, skin = -1;
  int firstVertex = 0;  ///< of this part in the whole shape
  const tinygltf::Primitive* primitive = nullptr;
  Eigen::Affine3d instance = Eigen::Affine3d::Identity();  ///< where this copy of the mesh stands, seen from its node
  Positions positions, normals;                            ///< normals may be empty
  int influences = 0;                                      ///< joints per vertex, 0 without a skin
  std::vector<std::uint32_t> joints;  ///< influences a vertex: places in the skin's joint list, in range
  std::vector<double> weights;        ///< as many, summing to 1 at each vertex
  std::string name;                   ///< for messages: mesh 0, primitive 1
};

/// Joints of a skin and the matrices that take the mesh into each joint's space.
struct GltfSkin {
  std::vector<int> joints;
  std::vector<Eigen::Affine3d> inverseBind;
};

struct GltfShape {
  const NodeGraph* graph = nullptr;  ///< of the scene, which must outlive the shape
  std::vector<GltfPart> parts;
  std::vector<GltfSkin> skins;
  std::vector<Triangle> faces;        ///< over all parts, in the file's order
  std::vector<MaterialGroup> groups;  ///< one per primitive
  int vertexCount = 0;
  bool hasNormals = false;  ///< every part has them
  std::vector<Warning> warnings;
  std::vector<ObjectFaces> objects;  ///< one for each mesh node, in the order of the faces
};

/// Reads every triangle primitive (lists, strips, fans) of every copy of these mesh nodes (see readScene), primitives
/// in the file's order. Lines and points are skipped with a warning. Faces of mirrored nodes are turned around. The
/// document and the graph must outlive the result. Errors: NoTriangles, MalformedFile, IndexOutOfRange, TooLarge.
Result<GltfShape> readShape(const GltfDocument& doc, const NodeGraph& graph, const std::vector<int>& meshNodes,
                            const FractionReport& onProgress = {});

}  // namespace shapespline
