// Mesh topology: edges, neighbours, components, and the defects of real files.
#pragma once

#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// Neighbours of each face.
using FaceGraph = CompressedRows<int>;

/// Faces at each vertex.
using VertexFaces = CompressedRows<int>;

VertexFaces facesOfVertices(int vertexCount, const std::vector<Triangle>& faces);

/// Counts of defects and features of a mesh.
struct MeshCounts {
  int edges = 0;
  int boundaryEdges = 0;      ///< with one adjacent face
  int nonManifoldEdges = 0;   ///< with three or more adjacent faces
  int inconsistentEdges = 0;  ///< two faces use the edge in the same direction
  int duplicateFaces = 0;     ///< faces with the same three vertices as an earlier one
};

MeshCounts countMesh(int vertexCount, const std::vector<Triangle>& faces, const FractionReport& onProgress = {});

/// Number of vertices without faces.
int countUnreferenced(int vertexCount, const std::vector<Triangle>& faces);

/// Number of components formed by the faces with `use`. Faces that share a vertex are in one component.
int countComponents(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress = {});

/// Whether each face has area in every pose (triangle.h).
std::vector<char> facesWithArea(const std::vector<Triangle>& faces, std::span<const Positions* const> poses,
                                const FractionReport& onProgress = {});

/// Neighbours across edges, among faces with `use`. If faces meet only in a vertex and no chain of edges connects them,
/// one link is added. The components of this graph are then the components of faces that share vertices.
FaceGraph dualGraph(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress = {});

/// For each side 3 f + c (from corner c of face f to the next), the next side along the same edge in ascending order,
/// cyclically. A single side and a side of zero length refer to themselves.
std::vector<int> nextAlongEdge(int vertexCount, const std::vector<Triangle>& faces,
                               const FractionReport& onProgress = {});

/// Connected components of a face graph.
struct Components {
  std::vector<int> ofFace;  ///< component of each face, or -1 for unused faces
  int count = 0;
};

/// Components of the faces with `use`, numbered by their lowest face.
Components connectedComponents(const FaceGraph& graph, const std::vector<char>& use,
                               const FractionReport& onProgress = {});

/// Diagonal of the bounding box of all positions in all poses.
double boundingDiagonal(std::span<const Positions* const> poses);

}  // namespace shapespline
