// Builds one mesh from all triangles of a glTF scene: parts, faces and skins.
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

/// Vertices of one primitive of one mesh node, before any transform. Primitives that share attributes share a part.
struct GltfPart {
  int node = -1, mesh = -1, skin = -1;
  int firstVertex = 0;  ///< index of the part's first vertex in the whole shape
  const tinygltf::Primitive* primitive = nullptr;
  Eigen::Affine3d instance = Eigen::Affine3d::Identity();  ///< transform of this copy of the mesh, relative to its node
  Positions positions, normals;                            ///< normals may be empty
  int influences = 0;                                      ///< joints per vertex; 0 without a skin
  std::vector<std::uint32_t> joints;  ///< `influences` per vertex: indices into the skin's joint list, in range
  std::vector<double> weights;        ///< a weight for each joint; the sum at each vertex is 1
  std::string name;                   ///< for messages, such as mesh 0, primitive 1
};

/// Joints of a skin, and the matrices that transform the mesh into each joint's space.
struct GltfSkin {
  std::vector<int> joints;
  std::vector<Eigen::Affine3d> inverseBind;
};

struct GltfShape {
  const NodeGraph* graph = nullptr;  ///< graph of the scene, which must outlive the shape
  std::vector<GltfPart> parts;
  std::vector<GltfSkin> skins;
  std::vector<Triangle> faces;        ///< faces of all parts, in file order
  std::vector<MaterialGroup> groups;  ///< one per primitive
  int vertexCount = 0;
  bool hasNormals = false;  ///< true if every part has normals
  std::vector<Warning> warnings;
  std::vector<ObjectFaces> objects;  ///< one object for each mesh node, in face order
};

/// Error for a file that shows no mesh, with advice.
Error noMesh(const GltfDocument& doc);

/// Reads every triangle primitive (lists, strips, fans) of every copy of these mesh nodes (see readScene), in file
/// order. Skips lines and points with a warning, and reverses faces of mirrored nodes. The document and the graph must
/// outlive the result. Errors: NoTriangles, MalformedFile, IndexOutOfRange, TooLarge.
Result<GltfShape> readShape(const GltfDocument& doc, const NodeGraph& graph, const std::vector<int>& meshNodes,
                            const FractionReport& onProgress = {});

}  // namespace shapespline
