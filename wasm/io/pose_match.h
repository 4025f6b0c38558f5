// Finds a mesh's vertices in another file's pose. Exporters may split and cut the same mesh differently in every pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

/// Pose vertices for the mesh's vertices or corners. Exactly one of the two lists is filled.
struct PoseMatch {
  std::vector<int> vertexOf;  ///< pose vertex for each mesh vertex
  std::vector<int> cornerOf;  ///< pose vertex for each corner 3 f + c of the mesh
};

/// Matches poses with the first key's mesh, which must outlive the matcher.
class PoseMatcher {
 public:
  PoseMatcher(const std::vector<Triangle>& faces, const Positions& positions) : faces_(faces), positions_(positions) {}

  /// Tries three methods to match a pose with the mesh, in this order:
  /// 1. the same vertices, with faces in any order and polygons cut along other diagonals (sameSurface);
  /// 2. as 1, after merging consecutive vertices at one position. Exporters such as Blender write a copy of a vertex
  /// for
  ///    each of its normals and texture coordinates, one after the other;
  /// 3. faces in the same order, whose corners determine the vertices: two corners are one vertex if they coincide in
  ///    the mesh and in the pose. Pairs of triangles may be cut along the other diagonal, as Blender cuts quads.
  /// Method 3 applies to any two lists of equal length. It succeeds if corners that coincide in one list coincide in
  /// the other, except where the shape touches itself in one of them. The pose must also not fit the mesh's own faces
  /// much better, which would indicate wrong indices. Method 3 is tried first if faces share no vertices, because the
  /// faces are then equal for both cuts of a quad. Returns nothing if all three fail. `poses`: all from one file.
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
