// Finds a mesh's vertices in another file's pose: exporters split and cut the same mesh differently in every pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

/// Vertices or faces of a pose for the mesh's vertices; one of the two is filled.
struct PoseMatch {
  std::vector<int> vertexOf;  ///< of each vertex of the mesh: one of the pose
  std::vector<int> cornerOf;  ///< of each corner 3 f + c of the mesh: a vertex of the pose
};

/// The first key's mesh. It must outlive this.
class PoseMatcher {
 public:
  PoseMatcher(const std::vector<Triangle>& faces, const Positions& positions) : faces_(faces), positions_(positions) {}

  /// The ways in which a pose can match the mesh, in the order in which they are tried:
  ///   1. the same vertices, with faces in any order and polygons cut along other diagonals (sameSurface);
  ///   2. the same, after consecutive vertices at one position are merged: exporters that sort the copies made for
  ///      normals and coordinates by vertex leave these (Blender);
  ///   3. faces in the same order, whose corners determine the vertices: two corners are one vertex if they coincide in
  ///      this mesh and in the pose. Pairs of triangles may be cut along the other diagonal, as Blender cuts quads.
  /// The third can be tried on any two lists of the same length. It holds only if corners that coincide in one of the
  /// two also do in the other, except where the shape touches itself in one of them, and if the pose does not match
  /// much better with the mesh's own faces, which indicates wrong indices. It is tried before the first if vertices are
  /// not shared, because then faces look alike however quads are cut. Returns nothing if none of the three holds.
  /// `poses` are of one file.
  std::optional<PoseMatch> find(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;

 private:
  std::optional<PoseMatch> byCopies(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;
  std::optional<PoseMatch> byCorners(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;

  const std::vector<Triangle>& faces_;
  const Positions& positions_;
};

/// Merges vertices that coincide in all poses of one file, up to rounding.
Welding weldPoses(std::span<const Positions* const> poses);

}  // namespace shapespline
