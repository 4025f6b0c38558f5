// Finds a mesh's vertices in another file's pose of it: exporters split and cut the same mesh otherwise in every pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

/// What a pose has for the mesh's vertices; one of the two is filled.
struct PoseMatch {
  std::vector<int> vertexOf;  ///< of each vertex of the mesh: one of the pose
  std::vector<int> cornerOf;  ///< of each corner 3 f + c of the mesh: a vertex of the pose
};

/// The first key's mesh. It must outlive this.
class PoseMatcher {
 public:
  PoseMatcher(const std::vector<Triangle>& faces, const Positions& positions) : faces_(faces), positions_(positions) {}

  /// The ways in which a pose may hold the mesh, in the order in which they are tried:
  ///   1. the same vertices, with faces in any order and polygons cut along other diagonals (sameSurface);
  ///   2. the same once copies that follow each other at one place are one vertex: what exporters leave that sort
  ///      the copies made for normals and coordinates by vertex (Blender);
  ///   3. faces in the same order, whose corners tell the vertices: two corners are one vertex where they coincide in
  ///      this mesh and in the pose. Pairs of triangles may be cut along the other diagonal, as Blender cuts quads.
  /// The third one may be asked of any two lists of as many faces: it holds only where corners that coincide in one of
  /// the two do so in the other, but for places where the shape touches itself in one of them, and where the pose is
  /// not much more like the mesh with the mesh's own faces: these name wrong vertices then. It comes before the first
  /// one where vertices are not shared: numbered as they come, such faces look alike however their quads are cut.
  /// Nothing where none of the three holds. `poses` are of one file.
  std::optional<PoseMatch> find(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;

 private:
  std::optional<PoseMatch> byCopies(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;
  std::optional<PoseMatch> byCorners(const std::vector<Triangle>& faces, std::span<const Positions* const> poses) const;

  const std::vector<Triangle>& faces_;
  const Positions& positions_;
};

/// Vertices that coincide in all poses of one file, as rounding leaves them.
Welding weldPoses(std::span<const Positions* const> poses);

}  // namespace shapespline
