// What a list of triangles says about itself: shared edges, neighbours, components, and the flaws that real files have.
#pragma once

#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// A graph on faces: the neighbours of each.
using FaceGraph = CompressedRows<int>;

/// For each vertex the faces at it.
using VertexFaces = CompressedRows<int>;

VertexFaces facesOfVertices(int vertexCount, const std::vector<Triangle>& faces);

/// Flaws and features of a mesh, counted.
struct MeshCounts {
  int edges = 0;
  int boundaryEdges = 0;      ///< with one face
  int nonManifoldEdges = 0;   ///< with three faces or more
  int inconsistentEdges = 0;  ///< two faces run along it in the same direction
  int duplicateFaces = 0;     ///< faces with the same three vertices as an earlier one
};

MeshCounts countMesh(int vertexCount, const std::vector<Triangle>& faces, const FractionReport& onProgress = {});

/// Vertices that no face has.
int countUnreferenced(int vertexCount, const std::vector<Triangle>& faces);

/// How many components those faces form for which `use` is true: faces that share a vertex are of one component.
int countComponents(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress = {});

/// Of each face whether it has area in every pose (triangle.h).
std::vector<char> facesWithArea(const std::vector<Triangle>& faces, std::span<const Positions* const> poses,
                                const FractionReport& onProgress = {});

/// Neighbours across edges, between those faces for which `use` is true. Where faces meet only in a vertex (and no
/// chain of edges joins them) one link is added, so the components of this graph are the components that share
/// vertices.
FaceGraph dualGraph(int vertexCount, const std::vector<Triangle>& faces, const std::vector<char>& use,
                    const FractionReport& onProgress = {});

/// Of each side 3 f + c, which runs from corner c of face f to the next, the next side along the same edge in ascending
/// order, the first after the last: a side alone, and one without length, is its own.
std::vector<int> nextAlongEdge(int vertexCount, const std::vector<Triangle>& faces,
                               const FractionReport& onProgress = {});

/// Connected components of a face graph.
struct Components {
  std::vector<int> ofFace;  ///< component of each face; -1 where the face is not used
  int count = 0;
};

/// Of those faces for which `use` is true, numbered by their lowest face.
Components connectedComponents(const FaceGraph& graph, const std::vector<char>& use,
                               const FractionReport& onProgress = {});

/// Length of the diagonal of the box around all positions of all poses.
double boundingDiagonal(std::span<const Positions* const> poses);

}  // namespace shapespline
